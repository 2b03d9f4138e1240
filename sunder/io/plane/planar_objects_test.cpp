#include <sunder/base/error.h>
#include <sunder/io/plane/planar_objects.h>
#include <sunder/io/text/file.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace sunder::io {
namespace {

using PlanarKind = PlanarObject::Kind;
using PlanarPoints = std::vector<Point2>;

std::string planar_refusal(std::string_view text, std::string_view place, bool drop_z = false) {
  try {
    parse_planar_objects(text, place, drop_z);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PlanarObjectsTest, Wkt) {
  const PlanarFile file = parse_planar_objects(
      "POINT (1 2)\nLINESTRING (0 0, 3 4)\n\nPOLYGON ((0 0, 1 0, 0 1, 0 0))\nPOINTZ (1 2 3)\n", "some.wkt", true);
  ASSERT_EQ(file.objects.size(), 4u);
  EXPECT_EQ(file.format, "WKT");
  EXPECT_EQ(file.objects[0].kind, PlanarKind::point);
  EXPECT_EQ(file.objects[0].vertices, (PlanarPoints{{1, 2}}));
  EXPECT_EQ(file.objects[1].kind, PlanarKind::segment);
  EXPECT_EQ(file.objects[1].vertices, (PlanarPoints{{0, 0}, {3, 4}}));
  EXPECT_EQ(file.objects[2].kind, PlanarKind::polygon);
  EXPECT_EQ(file.objects[2].vertices, (PlanarPoints{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(file.objects[2].line, 4u);
  EXPECT_EQ(file.objects[2].name, "3");
  EXPECT_EQ(file.objects[3].kind, PlanarKind::point);
}

TEST(PlanarObjectsTest, GeoJson) {
  const PlanarFile file = parse_planar_objects(
      R"({"type":"FeatureCollection","features":[
        {"type":"Feature","id":"mast","geometry":{"type":"Point","coordinates":[5,6]}},
        {"type":"Feature","properties":{"name":"pond"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}}]})",
      "some.geojson");
  ASSERT_EQ(file.objects.size(), 2u);
  EXPECT_EQ(file.objects[0].name, "mast");
  EXPECT_EQ(file.objects[0].vertices, (PlanarPoints{{5, 6}}));
  EXPECT_EQ(file.objects[1].name, "pond");
  EXPECT_EQ(file.objects[1].vertices.size(), 3u);
}

TEST(PlanarObjectsTest, Csv) {
  const PlanarFile polygon = parse_planar_objects("x,y\n0,0\n1,0\r\n\n0,1\n0,0\n", "some.csv");
  ASSERT_EQ(polygon.objects.size(), 1u);
  EXPECT_EQ(polygon.objects[0].kind, PlanarKind::polygon);
  EXPECT_EQ(polygon.objects[0].vertices, (PlanarPoints{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(parse_planar_objects("0;7", "some.csv").objects[0].kind, PlanarKind::point);
  EXPECT_EQ(parse_planar_objects("0,7\n1,7", "some.csv").objects[0].kind, PlanarKind::segment);
  const PlanarFile segments = parse_planar_objects("0,0,1,1,first\n5,5,5,5,second\n", "some.csv");
  ASSERT_EQ(segments.objects.size(), 2u);
  EXPECT_EQ(segments.objects[0].name, "first");
  EXPECT_EQ(segments.objects[1].kind, PlanarKind::point);
}

TEST(PlanarObjectsTest, CsvOfKinds) {
  const PlanarFile file = parse_planar_objects(
      "Kind;x1;y1;x2;y2;name\r\nline;0;0;1;2;axis\rRAY;3;4;-5;6\n\n\"half-plane\";0;1; 0 ;-1;left\nHalfPlane;1;1;2;2;\n"
      "point;7;8\nsegment;0;0;1;1;bar\nsegment;2;2;2;2\n",
      "some.csv");
  const std::vector<std::pair<PlanarKind, PlanarPoints>> expected{{PlanarKind::line, {{0, 0}, {1, 2}}},
                                                                  {PlanarKind::ray, {{3, 4}, {-5, 6}}},
                                                                  {PlanarKind::half_plane, {{0, 1}, {0, -1}}},
                                                                  {PlanarKind::half_plane, {{1, 1}, {2, 2}}},
                                                                  {PlanarKind::point, {{7, 8}}},
                                                                  {PlanarKind::segment, {{0, 0}, {1, 1}}},
                                                                  {PlanarKind::point, {{2, 2}}}};
  const std::vector<std::string> names{"axis", "2", "left", "4", "5", "bar", "7"};
  const std::vector<std::uint32_t> lines{2, 3, 5, 6, 7, 8, 9};
  ASSERT_EQ(file.objects.size(), expected.size());
  EXPECT_EQ(file.format, "CSV");
  for (std::size_t i = 0; i < expected.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(file.objects[i].kind, expected[i].first);
    EXPECT_EQ(file.objects[i].vertices, expected[i].second);
    EXPECT_EQ(file.objects[i].name, names[i]);
    EXPECT_EQ(file.objects[i].line, lines[i]);
    EXPECT_EQ(file.objects[i].unbounded(), i < 4);
  }
}

TEST(PlanarObjectsTest, WktOfLines) {
  const PlanarFile mixed = parse_planar_objects(
      "POINT (1 2)\r\nLINE (0 0, 1 2)\n\nray( -1 0.5 ,2 1e3 )\nPOLYGON ((0 0, 1 0, 0 1, 0 0))\nHalf-Plane (0 0, 0 1)\n",
      "some.wkt");
  const std::vector<PlanarKind> kinds{PlanarKind::point, PlanarKind::line, PlanarKind::ray, PlanarKind::polygon,
                                      PlanarKind::half_plane};
  const std::vector<std::uint32_t> lines{1, 2, 4, 5, 6};
  ASSERT_EQ(mixed.objects.size(), kinds.size());
  EXPECT_EQ(mixed.format, "WKT");
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    EXPECT_EQ(mixed.objects[i].kind, kinds[i]);
    EXPECT_EQ(mixed.objects[i].name, std::to_string(i + 1));
    EXPECT_EQ(mixed.objects[i].line, lines[i]);
  }
  EXPECT_EQ(mixed.objects[2].vertices, (PlanarPoints{{-1, 0.5}, {2, 1000}}));
  const PlanarFile alone = parse_planar_objects("\xef\xbb\xbfLINE (0 0 9, 1 2 9)\n", "some.WKT", true);
  ASSERT_EQ(alone.objects.size(), 1u);
  EXPECT_EQ(alone.objects[0].vertices, (PlanarPoints{{0, 0}, {1, 2}}));
  EXPECT_EQ(alone.format, "WKT");
  // The words are ours in WKT only.
  EXPECT_NE(planar_refusal("LINE (0 0, 1 2)", "some.geojson"), "accepted");
}

// What comes first is not taken for a line of names unless it is one; a byte order mark is nothing.
TEST(PlanarObjectsTest, NoVertexIsLost) {
  EXPECT_EQ(parse_planar_objects("\xef\xbb\xbf"
                                 "0,0\n1,0\n0,1\n",
                                 "some.csv")
                .objects[0]
                .vertices.size(),
            3u);
  EXPECT_EQ(parse_planar_objects("0,0\r1,0\r0,1\r", "some.csv").objects[0].vertices.size(), 3u);
  EXPECT_EQ(parse_planar_objects("\"x\",\"y\"\n0,0\n1,0\n0,1\n", "some.csv").objects[0].vertices.size(), 3u);
  EXPECT_EQ(planar_refusal("O,0\n1,0\n0,1\n", "some.csv").substr(0, 14), "some.csv:1: 'O");
  EXPECT_EQ(planar_refusal("x,y\n", "some.csv"), "some.csv: has a line of names only; give vertices behind it");
}

// Every file of cases/broken-planar is refused as its table says.
TEST(PlanarObjectsTest, BrokenFiles) {
  const std::filesystem::path folder = std::filesystem::path(tests::cases_folder()) / "broken-planar";
  std::set<std::string> seen{"EXPECTED.tsv", "README.md"}, found;
  std::istringstream table(read_file(folder / "EXPECTED.tsv"));
  for (std::string row; std::getline(table, row);) {
    if (row.starts_with('#')) continue;
    const std::size_t tab = row.find('\t');
    ASSERT_NE(tab, std::string::npos) << row;
    const std::string name = row.substr(0, tab), part = row.substr(tab + 1);
    SCOPED_TRACE(name);
    EXPECT_TRUE(seen.insert(name).second) << "twice in the table";
    const std::string path = (folder / name).string(), message = planar_refusal(read_file(path), path);
    EXPECT_TRUE(message.starts_with(path + part)) << "expected: " << part << "\nmessage: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) found.insert(entry.path().filename().string());
  EXPECT_EQ(seen, found) << "EXPECTED.tsv and the folder differ";
  EXPECT_GE(seen.size(), 20u);
}

TEST(PlanarObjectsTest, BadFiles) {
  EXPECT_EQ(planar_refusal("", "some.csv"), "some.csv: has nothing in it; give a file with lines");
  EXPECT_EQ(planar_refusal("0,0\n1,nan\n", "some.csv").substr(0, 16), "some.csv:2: 'nan");
  EXPECT_EQ(planar_refusal("0,0\n1,2,3\n", "some.csv"),
            "some.csv:2: has 3 fields; give two, x and y, as in the lines before");
  EXPECT_EQ(planar_refusal("LINESTRING (0 0, 1 1, 2 0)", "some.wkt"),
            "some.wkt:1: has several segments; give a point, a segment or a polygon");
  EXPECT_EQ(planar_refusal("POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1))", "some.wkt"),
            "some.wkt:1: has holes, or several parts; give one polygon without holes");
  EXPECT_EQ(planar_refusal("POLYGON ((0 0, 9 0, 0 9))", "some.wkt"),
            "some.wkt:1: ring 0: does not end where it began; repeat its first point at its end");
  EXPECT_EQ(planar_refusal("POINT (1 2 3)", "some.wkt"),
            "some.wkt:1: has a third coordinate; to ignore it, give --drop-z");
  EXPECT_EQ(planar_refusal("POINT EMPTY", "some.wkt"), "some.wkt: has no objects; give a file with objects");
  EXPECT_NE(planar_refusal("x,y,r,name\n0,0,1,a\n", "some.csv")
                .find(":1: the columns are named x,y,r,name, but vertices have x,y"),
            std::string::npos);
  EXPECT_NE(
      planar_refusal("lon,lat\n0,0\n", "some.csv").find(":1: the columns are named lon,lat, but vertices have x,y"),
      std::string::npos);
  EXPECT_NE(planar_refusal("kind,id,x1,y1,x2,y2\nline,1,0,0,1,1\n", "some.csv")
                .find(":1: column 2 is named 'id'; the order is"),
            std::string::npos);
  EXPECT_NE(planar_refusal("x,y,z\n0,0,1\n", "some.csv").find(":1: has a third coordinate, 'z'"), std::string::npos);
  EXPECT_EQ(parse_planar_objects("name,Y,X\na,1,0\n", "some.csv").objects[0].vertices, (PlanarPoints{{0, 1}}));
  EXPECT_EQ(planar_refusal("CIRCLE (1 2)", "some.wkt"),
            "some.wkt:1: 'CIRCLE' is not read here; give POINT, LINESTRING, MULTILINESTRING, POLYGON or MULTIPOLYGON");
}

// What is no object here is refused where it is asked about, not beside others.
TEST(PlanarObjectsTest, ProblemsOfOthers) {
  const PlanarFile file = parse_planar_objects(
      "POINT (1 2)\nPOLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1))\nPOLYGON ((0 0, 9 0, 0 9))\n"
      "LINESTRING (0 0, 1 1, 2 0)\nSRID=7;POLYGON ((0 0, 9 0, 0 9, 0 0))\n",
      "some.wkt");
  ASSERT_EQ(file.objects.size(), 5u);
  for (const std::size_t i : {1u, 2u, 3u}) {
    EXPECT_FALSE(file.objects[i].problem.empty()) << i;
    EXPECT_TRUE(file.objects[i].vertices.empty()) << i;
    EXPECT_EQ(file.objects[i].line, i + 1);
    EXPECT_THROW(require_object(file.objects[i], "some.wkt"), Error);
  }
  EXPECT_EQ(file.objects[4].vertices.size(), 3u);
  EXPECT_EQ(file.objects[4].system.id, "EPSG:7");
  EXPECT_NO_THROW(require_object(file.objects[0], "some.wkt"));
}

// What is a board by its first letters, whatever its name ends with: tracks, in no coordinate system.
TEST(PlanarObjectsTest, OfABoardTracks) {
  const PlanarFile file = parse_planar_objects(
      "(kicad_pcb (version 20221018) (net 1 \"GND\")\n"
      "  (segment (start 100 100) (end 110 100) (width 0.25) (layer \"F.Cu\") (net 1)))\n",
      "board");
  ASSERT_EQ(file.objects.size(), 1u);
  EXPECT_EQ(file.objects[0].kind, PlanarKind::segment);
  EXPECT_EQ(file.objects[0].vertices, (PlanarPoints{{100, 100}, {110, 100}}));
  EXPECT_FALSE(file.objects[0].system.declared());
}

TEST(PlanarObjectsTest, Endings) {
  EXPECT_TRUE(is_planar("a/b.WKT"));
  EXPECT_TRUE(is_planar("b.geojson"));
  EXPECT_TRUE(is_planar("b.geojsonl"));
  EXPECT_FALSE(is_planar("b.obj"));
  EXPECT_FALSE(is_planar("b"));
}

}  // namespace
}  // namespace sunder::io
