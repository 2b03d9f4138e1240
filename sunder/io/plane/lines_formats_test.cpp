// GeoJSON of a line each, CSV with WKT, empty rings.
#include <sunder/base/error.h>
#include <sunder/io/plane/lines.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sunder::io {
namespace {

using Names = std::vector<std::string>;

std::string line_format_error(const std::string& text, const std::string& place) {
  try {
    parse_lines(text, place);
  } catch (const Error& problem) {
    return problem.what();
  }
  return "accepted";
}

// What begins alike is read.
TEST(LinesFormatsTest, NotForeign) {
  EXPECT_EQ(parse_lines("0101,0,1,1\n", "a.csv").segments.size(), 1u);
  EXPECT_EQ(parse_lines("VERSION,x1,y1,x2,y2\n5,0,0,1,1\n", "a.csv").segments.size(), 1u);
}

TEST(LinesFormatsTest, GeoJsonOfLines) {
  const auto line = [](const std::string& end) {
    return R"({"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, 0], )" + end + "]}}";
  };
  const std::string first = line("[1, 1]"), second = line("[2, 2]");
  for (const std::string& text :
       {first + "\n" + second, first + "\r\n\r\n" + second + "\r\n", "\x1e" + first + "\n\x1e" + second + "\n"}) {
    const LineFile file = parse_lines(text, "-");
    ASSERT_EQ(file.segments.size(), 2u);
    EXPECT_EQ(file.segments[1].b.x, 2);
    EXPECT_EQ(file.source[0].line, 1u);
    EXPECT_GE(file.source[1].line, 2u);
  }
  // A record may go over several lines; an object may be spread over them, too.
  const std::string spread = "\x1e{\"type\": \"LineString\",\n\"coordinates\": [[0, 0],\n[3, 3]]}\n\x1e" + first + "\n";
  EXPECT_EQ(parse_lines(spread, "a.geojsons").source[1].line, 4u);
  EXPECT_EQ(parse_lines("{\n\"type\": \"LineString\", \"coordinates\": [[0, 0], [3, 3]]\n}", "-").segments.size(), 1u);
  EXPECT_NE(line_format_error(first + "\n{\"type\":", "a.json").find("a.json:2: is not JSON"), std::string::npos);
  EXPECT_NE(line_format_error(first + "\n{\"type\":\"Feature\"}", "a.json").find("a.json:2: has no \"geometry\""),
            std::string::npos);
}

TEST(LinesFormatsTest, CsvWithWkt) {
  const std::string text =
      "id,Geom,use\r\na,\"LINESTRING (0 0, 1 1)\",x\r\nb,\"POLYGON ((0 0,\n1 0, 0 1, 0 0))\",y\r\nc,,x\r\n"
      "d,SRID=7;POINT EMPTY,x\r\n";
  const LineFile file = parse_lines(text, "a.csv", {.group = "use", .properties = {"use"}});
  EXPECT_EQ(file.format, "CSV with WKT");
  EXPECT_EQ(file.features, (Names{"a", "b", "c", "d"}));
  EXPECT_EQ(file.segments.size(), 4u);
  EXPECT_EQ(file.rings.size(), 1u);
  EXPECT_EQ(file.source[1].line, 3u);
  EXPECT_EQ(file.groups, (Names{"x", "y"}));
  EXPECT_EQ(file.properties.size(), 4u);
  EXPECT_EQ(parse_lines(text, "a.csv", {.group = "ring"}).groups, (Names{"a, line 0", "b, ring 0"}));
  EXPECT_EQ(parse_lines(text, "a.csv", {.group = "feature"}).groups, (Names{"a", "b"}));
  EXPECT_EQ(parse_lines("x1,y1,x2,y2,geom\n0,0,1,1,?\n", "a.csv").format, "CSV");
  EXPECT_NE(line_format_error("wkt\n\"LINESTRING (0 0,\n1)\"\n", "a.csv").find("a.csv:3: a point has two numbers"),
            std::string::npos);
}

TEST(LinesFormatsTest, EmptyRings) {
  const LineFile file =
      parse_lines("POLYGON ((0 0, 4 0, 0 4, 0 0), EMPTY, (1 1, 2 1, 1 2, 1 1))\nPOLYGON (EMPTY)\n", "a.wkt");
  EXPECT_EQ(file.rings.size(), 2u);
  EXPECT_EQ(file.remarks, (Names{"holes that are empty: 1, the first of line 1; they hold nothing",
                                 "geometries that are null or empty: 1, the first of line 2; they hold nothing"}));
  EXPECT_EQ(
      parse_lines(R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]], []]})", "a.json").remarks,
      Names{"holes that are empty: 1, the first of '1'; they hold nothing"});
  EXPECT_NE(
      line_format_error("POLYGON (EMPTY, (0 0, 4 0, 0 4, 0 0))", "a.wkt").find("a.wkt:1: the outer ring is empty"),
      std::string::npos);
}

}  // namespace
}  // namespace sunder::io
