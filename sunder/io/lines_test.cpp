// What the reader of lines takes, and what it says of what it does not take.
#include <sunder/base/error.h>
#include <sunder/io/lines.h>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace sunder::io {
namespace {

using planar::Segment;

const std::filesystem::path cases = std::filesystem::path(SUNDER_CASES_DIR) / "segments";

std::string error(const std::string& text, const std::string& place, bool drop_z = false) {
  try {
    parse_lines(text, place, drop_z);
  } catch (const Error& problem) {
    EXPECT_EQ(problem.code(), ErrorCode::bad_file);
    return problem.what();
  }
  return "accepted";
}

TEST(LinesTest, Csv) {
  const LineFile file = read_lines(cases / "wires.csv");
  EXPECT_EQ(file.format, "CSV");
  ASSERT_EQ(file.segments.size(), 5u);
  EXPECT_EQ(file.segments[1], (Segment{{0, 1}, {4, 2}}));
  EXPECT_EQ(file.features, (std::vector<std::string>{"ground", "clock", "data", "reset", "power"}));
  EXPECT_EQ(file.source[3].feature, 3u);
  EXPECT_EQ(file.source[3].line, 5u);
}

TEST(LinesTest, CsvWithoutNames) {
  const LineFile file = parse_lines("1;2;3;4\r\n\r\n -1e3 ; +5; 2;.5\r\n", "numbers");
  ASSERT_EQ(file.segments.size(), 2u);
  EXPECT_EQ(file.segments[1], (Segment{{-1000, 5}, {2, 0.5}}));
  EXPECT_EQ(file.features, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(file.source[1].line, 3u);
}

TEST(LinesTest, CsvInQuotesAndWithOldLineEnds) {
  const LineFile file = parse_lines("\"0\",\"0\",\"1\",\"1\"\r0,0,1,1,a\r\n0,1,1,0,\"b c\"\r", "a.csv");
  ASSERT_EQ(file.segments.size(), 3u);
  EXPECT_EQ(file.segments[0], (Segment{{0, 0}, {1, 1}}));
  EXPECT_EQ(file.features, (std::vector<std::string>{"1", "a", "b c"}));
  EXPECT_EQ(file.source[2].line, 3u);
}

TEST(LinesTest, Wkt) {
  const LineFile file = read_lines(cases / "paths.wkt");
  EXPECT_EQ(file.format, "WKT");
  ASSERT_EQ(file.segments.size(), 2u + 1 + 2 + 4 + 3);
  EXPECT_EQ(file.segments[2], (Segment{{2, 2}, {4, 3}}));
  EXPECT_EQ(file.segments.back(), (Segment{{12, 2}, {11, 1}}));
  EXPECT_EQ(file.source.back().feature, 3u);
  EXPECT_EQ(file.source.back().line, 4u);
  EXPECT_EQ(parse_lines("multipolygon(((0 0,1 0,0 1,0 0)),((5 5,6 5,5 6,5 5)))", "x.wkt").segments.size(), 6u);
  EXPECT_EQ(parse_lines("LINESTRING Z (0 0 7, 1 1 7)", "x.wkt", true).segments[0], (Segment{{0, 0}, {1, 1}}));
}

TEST(LinesTest, GeoJson) {
  const LineFile file = read_lines(cases / "pond.geojson");
  EXPECT_EQ(file.format, "GeoJSON");
  ASSERT_EQ(file.segments.size(), 4u + 3 + 1);
  EXPECT_EQ(file.segments.back(), (Segment{{4, 9}, {4, 6}}));
  EXPECT_EQ(file.features, (std::vector<std::string>{"pond", "jetty"}));
  EXPECT_EQ(file.source.back().line, 0u);
  const std::string collection =
      R"({"type": "GeometryCollection", "geometries": [{"type": "LineString", "coordinates": [[0, 0, 5], [1, 1, 5]]},
          {"type": "MultiPolygon", "coordinates": [[[[0, 0], [1, 0], [0, 1], [0, 0]]]]}]})";
  EXPECT_EQ(parse_lines(collection, "-", true).segments.size(), 4u);
}

TEST(LinesTest, Rings) {
  const auto rings = [](const LineFile& file) {
    std::vector<std::array<std::uint32_t, 3>> found;
    for (const LineRing& r : file.rings) found.push_back({r.first, r.count, r.polygon});
    return found;
  };
  using Rings = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(rings(read_lines(cases / "wires.csv")), Rings{});
  EXPECT_EQ(rings(read_lines(cases / "paths.wkt")), (Rings{{5, 4, 0}, {9, 3, 0}}));
  EXPECT_EQ(rings(read_lines(cases / "pond.geojson")), (Rings{{0, 4, 0}, {4, 3, 0}}));
  EXPECT_EQ(rings(parse_lines("MULTIPOLYGON(((0 0,1 0,0 1,0 0)),((5 5,6 5,5 6,5 5),(7 7,8 7,7 8,7 7)))", "x.wkt")),
            (Rings{{0, 3, 0}, {3, 3, 1}, {6, 3, 1}}));
  const LineFile plain = parse_lines("[[[0, 0], [4, 0], [4, 4]], [[1, 1], [2, 1], [2, 2], [1, 1]]]", "x.json");
  EXPECT_EQ(rings(plain), (Rings{{0, 3, 0}, {3, 3, 0}}));
  EXPECT_EQ(plain.segments[2], (Segment{{4, 4}, {0, 0}}));
}

TEST(LinesTest, DeepNestingIsRefused) {
  std::string text = R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})";
  for (int depth = 0; depth < 100; ++depth) {
    EXPECT_EQ(parse_lines(text, "a.json").segments.size(), 1u) << depth;
    text = R"({"type": "GeometryCollection", "geometries": [)" + text + "]}";
  }
  text = R"({"type": "GeometryCollection", "geometries": [)" + text + "]}";
  EXPECT_NE(error(text, "a.json").find("nested 100 deep"), std::string::npos);
}

TEST(LinesTest, WhatIsWrongAndWhere) {
  const std::vector<std::array<std::string, 3>> wrong{
      {"a.csv", " \n", "a.csv: has nothing in it"},
      {"a.csv", "x1,y1,x2,y2\n", "a.csv: has no segments"},
      {"a.csv", "1,2,3,4\n1,2,3\n", "a.csv:2: has 3 fields"},
      {"a.csv", "1,2,3,4\n1,2,nan,4\n", "a.csv:2: 'nan' is NaN"},
      {"a.csv", "1,2,3,4\n\n1,2,3,1e999\n", "a.csv:3: '1e999' is too large"},
      {"a.csv", "1,2,3,x\n", "a.csv:1: 'x' is not a number"},
      {"a.csv", "inf,0,1,1\n5,5,6,6\n", "a.csv:1: 'inf' is infinite"},
      {"a.csv", "nan,nan,nan,nan\n5,5,6,6\n", "a.csv:1: 'nan' is NaN"},
      {"a.csv", "-1e400,0,1,1\n5,5,6,6\n", "a.csv:1: '-1e400' is too large"},
      {"a.csv", ".x,0,1,1\n5,5,6,6\n", "a.csv:1: '.x' is not a number"},
      {"a.csv", "0,5;1,0;2,0;3,0\n", "a.csv:1: '0,5'"},
      {"a.csv", "x1,y1,z1,x2,y2,z2\n0,0,0,1,1,0\n", "a.csv:1: has 6 fields"},
      {"a.csv", "id,x1,y1,x2,y2\n1,0,0,5,5\n", "the order is x1,y1,x2,y2,id"},
      {"a.csv", "0,0,1,1,\"a,b\"\n", "a.csv:1"},
      {"a.wkt", "LINESTRING (0 0, 1 1\n", "a.wkt:1: ends where ')' is expected"},
      {"a.wkt", "LINESTRING (0 0)\n", "a.wkt:1: a line has fewer than two points"},
      {"a.wkt", "LINESTRING (0 0, 1)\n", "a.wkt:1: a point has two numbers"},
      {"a.wkt", "LINESTRING (0 0 0, 1 1 1)\n", "--drop-z"},
      {"a.wkt", "LINESTRING EMPTY\n", "a.wkt:1: is empty"},
      {"a.wkt", "LINESTRING (0 0, inf 1)\n", "'inf' is infinite"},
      {"a.wkt", "LINESTRING (0 0, 1 1) x\n", "'x' stands after"},
      {"a.wkt", "POINT (0 0)\n", "a.wkt:1: 'POINT' is not read here"},
      {"a.wkt", "POLYGON ((0 0, 1 0, 0 1, 1 1))\n", "does not end where it began"},
      {"a.wkt", "POLYGON ((0 0, 1 0, 0 0))\n", "fewer than four points"},
      {"a.wkt", "LINESTRING (0 0, 1 1)\nLINESTRING 0 0\n", "a.wkt:2: '0 0' stands where '(' is expected"},
      {"a.json", "{\"type\": \"LineString\", \n \"coordinates\": [[0, 0], [1, 1]",
       "a.json: is not JSON that can be read: at line 2, column"},
      {"a.json", R"({"type": "LineString", "coordinates": [[0, 0], [1, 1e999]]})", "number overflow"},
      {"a.json", "[1, 2]", "an object with a \"type\" is expected"},
      {"a.json", R"({"type": "Point", "coordinates": [0, 0]})", "'Point' has no segments"},
      {"a.json", R"({"type": "FeatureCollection"})", "no list \"features\""},
      {"a.json", R"({"type": "Feature", "id": 7, "geometry": null})", "feature '7': has no geometry"},
      {"a.json", R"({"type": "LineString", "coordinates": [[0, 0], ["1", 1]]})", "not a list of two numbers"},
      {"a.json", R"({"type": "LineString", "coordinates": [[0, 0, 1], [1, 1, 1]]})", "--drop-z"},
      {"a.json", R"({"type": "Polygon", "coordinates": [[0, 0], [1, 1]]})", "not a list of two numbers"},
      {"a.json", R"({"type": "MultiPolygon", "coordinates": [5]})", "depth"},
      {"a.json", R"({"type": "Polygon", "coordinates": []})", "an empty one"},
  };
  for (const auto& [place, text, part] : wrong) {
    const std::string message = error(text, place);
    EXPECT_NE(message.find(part), std::string::npos) << text << "\n" << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(message.starts_with(place)) << message;
  }
}

}  // namespace
}  // namespace sunder::io
