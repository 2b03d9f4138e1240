#include <sunder/io/mesh/space_objects.h>
#include <sunder/io/text/file.h>

#include <gtest/gtest.h>
#include <tests/support/places.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>
#include <string>

namespace sunder::io {
namespace {

using tests::cases;
using SpaceKind = SpaceObject::Kind;
using SpacePoints = std::vector<Point3>;

std::string space_refusal(const std::string& text, const std::string& place) {
  try {
    (void)parse_space_object(text, place);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.what();
  }
  return "nothing";
}

TEST(SpaceObjects, Json) {
  const SpaceObject point = parse_space_object("\xef\xbb\xbf {\"point\": [1, -0.0, 1e-320]}", "p.json");
  EXPECT_EQ(point.kind, SpaceKind::point);
  EXPECT_EQ(point.points, (SpacePoints{{1, 0, 1e-320}}));
  EXPECT_FALSE(std::signbit(point.points[0].y));
  EXPECT_EQ(point.format, "JSON");
  EXPECT_EQ(parse_space_object(R"({"segment": [[0,0,0],[1,2,3]]})", "s").points, (SpacePoints{{0, 0, 0}, {1, 2, 3}}));
  EXPECT_EQ(parse_space_object(R"({"segment": [[1,2,3],[1,2,3]]})", "s").kind, SpaceKind::point);
  const SpaceObject ray = parse_space_object(R"({"ray": [[0,0,0],[1,2,3]]})", "s");
  EXPECT_EQ(ray.kind, SpaceKind::ray);
  EXPECT_TRUE(ray.unbounded());
  EXPECT_EQ(parse_space_object(R"({"line": [[0,0,0],[5e-324,0,0]]})", "s").kind, SpaceKind::line);
  const SpaceObject plane = parse_space_object(R"({"plane": {"offset": 4, "normal": [1,2,3]}})", "s");
  EXPECT_EQ(plane.plane, solid::Plane::at({1, 2, 3}, 4));
  EXPECT_EQ(parse_space_object(R"({"plane": {"point": [7,8,9], "normal": [1,2,3]}})", "s").plane,
            solid::Plane::through({7, 8, 9}, {1, 2, 3}));
  const SpaceObject polygon = parse_space_object(R"({"polygon": [[0,0,0],[1,0,1],[1,1,1],[0,1,0],[0,0,0]]})", "s");
  EXPECT_EQ(polygon.points.size(), 4u);
  EXPECT_FALSE(polygon.frame);
  const SpaceObject framed = parse_space_object(
      R"({"polygon": {"origin": [1,2,3], "u": [0.1,0.2,0.3], "v": [0,1,0], "vertices": [[0,0],[1,0.5],[0,1]]}})", "s");
  EXPECT_EQ(framed.points, (SpacePoints{{0, 0, 0}, {1, 0.5, 0}, {0, 1, 0}}));
  EXPECT_EQ(framed.frame->u, (Point3{0.1, 0.2, 0.3}));
}

TEST(SpaceObjects, Boxes) {
  const SpaceObject box = parse_space_object(R"({"box": {"size": [2, 4, 1]}})", "b");
  EXPECT_EQ(box.kind, SpaceKind::box);
  EXPECT_FALSE(box.unbounded() || box.round);
  ASSERT_EQ(box.points.size(), 8u);
  EXPECT_EQ(box.points[0], (Point3{-1, -2, -0.5}));
  EXPECT_EQ(box.points[5], (Point3{1, -2, 0.5}));
  EXPECT_EQ(mesh_of(box).vertices, box.points);
  EXPECT_THROW(parse_space_object(R"({"box": {"size": [2, -4, 1]}})", "b"), Error);
  EXPECT_THROW(parse_space_object(R"({"box": {"size": [2, 4]}})", "b"), Error);
  EXPECT_THROW(parse_space_object(R"({"box": [2, 4, 1]})", "b"), Error);
}

TEST(SpaceObjects, AllBitsOfNumbers) {
  // The nearest doubles: of halfway cases the even one, of integers beyond 2^64 too, and of the least.
  const SpaceObject object = parse_space_object(
      R"({"polygon": [[9007199254740993, 36893488147419107328, 0.1], [2.4703282292062328e-324, 4.9406564584124654e-324,
        1.7976931348623157e308], [0.3, 18446744073709551615, -5]]})",
      "s");
  EXPECT_EQ(object.points[0], (Point3{9007199254740992, 36893488147419107328.0, 0.1}));
  EXPECT_EQ(object.points[1].y, 5e-324);
  EXPECT_EQ(object.points[1].z, std::numeric_limits<double>::max());
  EXPECT_EQ(object.points[2].y, 18446744073709551616.0);
  EXPECT_EQ(parse_space_object("POINT Z (0.1 9007199254740993 4.9406564584124654e-324)", "s").points[0],
            (Point3{0.1, 9007199254740992, 5e-324}));
}

TEST(SpaceObjects, Wkt) {
  EXPECT_EQ(parse_space_object("point z(1 2 3)", "p.wkt").points, (SpacePoints{{1, 2, 3}}));
  EXPECT_EQ(parse_space_object("POINTZ (1 2 3)\n", "p.wkt").format, "WKT");
  const SpaceObject segment = parse_space_object("LINESTRING\nZ (0 0\t0,\r\n1 2 +3.5)", "p.wkt");
  EXPECT_EQ(segment.kind, SpaceKind::segment);
  EXPECT_EQ(segment.points, (SpacePoints{{0, 0, 0}, {1, 2, 3.5}}));
  EXPECT_EQ(parse_space_object("POLYGON Z ((0 0 0, 1 0 1, 0 1 0, 0 0 0))", "p.wkt").points.size(), 3u);
}

TEST(SpaceObjects, Projected) {
  const solid::Frame frame = solid::Frame::of({0, 0, 1}, {2, 0, 0}, {0, 1, 0});
  const std::string bent = R"({"polygon": [[0,0,0],[1,0,1],[1,1,1.5],[0,1,1]]})";
  const SpaceObject polygon = parse_space_object(bent, "p.json", &frame);
  EXPECT_EQ(polygon.points, (SpacePoints{{0, 0, 0}, {0.5, 0, 0}, {0.5, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(polygon.frame, frame);
  EXPECT_EQ(polygon.moved, 1);
  const solid::Frame skew = solid::Frame::of({1, 1, 0}, {1, 0, 0}, {1, 1, 0});
  EXPECT_EQ(parse_space_object(bent, "p.json", &skew).points[0], (Point3{0, -1, 0}));
  // A polygon that has a frame keeps it, and what is no polygon is as it is.
  const SpaceObject framed = parse_space_object(
      R"({"polygon": {"origin": [0,0,0], "u": [1,0,0], "v": [0,1,0], "vertices": [[0,0],[1,0],[0,1]]}})", "s", &frame);
  EXPECT_FALSE(framed.moved);
  EXPECT_FALSE(parse_space_object(R"({"point": [1,2,3]})", "s", &frame).frame);
}

TEST(SpaceObjects, WhatTheyAre) {
  EXPECT_TRUE(is_space_text(R"( {"plane": {}})"));
  EXPECT_TRUE(is_space_text("{}"));
  EXPECT_FALSE(is_space_text(R"({"type": "Point", "coordinates": [1, 2]})"));
  EXPECT_FALSE(is_space_text("[[0, 0], [1, 0]]"));
  EXPECT_TRUE(is_space_text("POINT Z (1 2 3)"));
  EXPECT_TRUE(is_space_text("  MULTIPOINT  z (1 2 3)"));
  EXPECT_FALSE(is_space_text("POINT (1 2 3)"));
  EXPECT_FALSE(is_space_text("LINE (0 0, 1 1)"));
  EXPECT_FALSE(is_space_text(""));
  EXPECT_FALSE(is_space_text("v 0 0 0\n"));
  EXPECT_TRUE(is_space_file(cases / "space" / "plane.json"));
  EXPECT_FALSE(is_space_file(cases / "mesh" / "cube.obj"));
  EXPECT_FALSE(is_space_file(cases / "planar-pair" / "plate.wkt"));
  EXPECT_FALSE(is_space_file(cases / "space" / "no such file.json"));
}

TEST(SpaceObjects, Meshes) {
  const Mesh triangle = mesh_of(parse_space_object(R"({"polygon": [[0,0,0],[1,0,0],[0,1,0]]})", "s"));
  EXPECT_EQ(triangle.polygon_count(), 1u);
  EXPECT_EQ(triangle.polygon_vertices, (std::vector<std::uint32_t>{0, 1, 2}));
  const Mesh segment = mesh_of(parse_space_object(R"({"segment": [[0,0,0],[1,0,0]]})", "s"));
  EXPECT_EQ(segment.polygon_count(), 0u);
  EXPECT_EQ(segment.vertices.size(), 2u);
}

// Every file of cases/space is read, and every file of cases/broken-space is refused as its table says.
TEST(SpaceObjects, Files) {
  int read = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(tests::cases_folder()) / "space")) {
    const std::string name = entry.path().filename().string();
    if (name == "README.md" || name == "bent.json") continue;
    EXPECT_TRUE(is_space_file(entry.path())) << name;
    EXPECT_NO_THROW((void)parse_space_object(read_file(entry.path()), name)) << name;
    ++read;
  }
  EXPECT_GE(read, 10);
  const std::filesystem::path folder = std::filesystem::path(tests::cases_folder()) / "broken-space";
  std::set<std::string> seen{"EXPECTED.tsv", "README.md"}, found;
  std::istringstream table(read_file(folder / "EXPECTED.tsv"));
  for (std::string row; std::getline(table, row);) {
    if (row.starts_with('#')) continue;
    const std::size_t tab = row.find('\t');
    ASSERT_NE(tab, std::string::npos) << row;
    const std::string name = row.substr(0, tab), part = row.substr(tab + 1);
    SCOPED_TRACE(name);
    EXPECT_TRUE(seen.insert(name).second) << "twice in the table";
    const std::string path = (folder / name).string(), text = read_file(path), message = space_refusal(text, path);
    EXPECT_TRUE(is_space_text(text));
    EXPECT_TRUE(message.starts_with(path + part)) << "expected: " << part << "\nmessage: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) found.insert(entry.path().filename().string());
  EXPECT_EQ(seen, found) << "EXPECTED.tsv and the folder differ";
  EXPECT_GE(seen.size(), 30u);
}

}  // namespace
}  // namespace sunder::io
