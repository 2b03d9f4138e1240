#include <sunder/base/error.h>
#include <sunder/io/planar_objects.h>

#include <gtest/gtest.h>

#include <string>

namespace sunder::io {
namespace {

using Kind = PlanarObject::Kind;
using Points = std::vector<Point2>;

std::string refusal(std::string_view text, std::string_view place, bool drop_z = false) {
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
  EXPECT_EQ(file.objects[0].kind, Kind::point);
  EXPECT_EQ(file.objects[0].vertices, (Points{{1, 2}}));
  EXPECT_EQ(file.objects[1].kind, Kind::segment);
  EXPECT_EQ(file.objects[1].vertices, (Points{{0, 0}, {3, 4}}));
  EXPECT_EQ(file.objects[2].kind, Kind::polygon);
  EXPECT_EQ(file.objects[2].vertices, (Points{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(file.objects[2].line, 4u);
  EXPECT_EQ(file.objects[2].name, "3");
  EXPECT_EQ(file.objects[3].kind, Kind::point);
}

TEST(PlanarObjectsTest, GeoJson) {
  const PlanarFile file = parse_planar_objects(
      R"({"type":"FeatureCollection","features":[
        {"type":"Feature","id":"mast","geometry":{"type":"Point","coordinates":[5,6]}},
        {"type":"Feature","properties":{"name":"pond"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}}]})",
      "some.geojson");
  ASSERT_EQ(file.objects.size(), 2u);
  EXPECT_EQ(file.objects[0].name, "mast");
  EXPECT_EQ(file.objects[0].vertices, (Points{{5, 6}}));
  EXPECT_EQ(file.objects[1].name, "pond");
  EXPECT_EQ(file.objects[1].vertices.size(), 3u);
}

TEST(PlanarObjectsTest, Csv) {
  const PlanarFile polygon = parse_planar_objects("x,y\n0,0\n1,0\r\n\n0,1\n0,0\n", "some.csv");
  ASSERT_EQ(polygon.objects.size(), 1u);
  EXPECT_EQ(polygon.objects[0].kind, Kind::polygon);
  EXPECT_EQ(polygon.objects[0].vertices, (Points{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(parse_planar_objects("0;7", "some.csv").objects[0].kind, Kind::point);
  EXPECT_EQ(parse_planar_objects("0,7\n1,7", "some.csv").objects[0].kind, Kind::segment);
  const PlanarFile segments = parse_planar_objects("0,0,1,1,first\n5,5,5,5,second\n", "some.csv");
  ASSERT_EQ(segments.objects.size(), 2u);
  EXPECT_EQ(segments.objects[0].name, "first");
  EXPECT_EQ(segments.objects[1].kind, Kind::point);
}

TEST(PlanarObjectsTest, BadFiles) {
  EXPECT_EQ(refusal("", "some.csv"), "some.csv: has nothing in it; give a file with lines");
  EXPECT_EQ(refusal("0,0\n1,nan\n", "some.csv").substr(0, 16), "some.csv:2: 'nan");
  EXPECT_EQ(refusal("0,0\n1,2,3\n", "some.csv"), "some.csv:2: has 3 fields; give two, x and y, as in the lines before");
  EXPECT_EQ(refusal("LINESTRING (0 0, 1 1, 2 0)", "some.wkt"),
            "some.wkt:1: has several segments; give a point, a segment or a polygon");
  EXPECT_EQ(refusal("POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1))", "some.wkt"),
            "some.wkt:1: has holes, or several parts; give one polygon without holes");
  EXPECT_EQ(refusal("POLYGON ((0 0, 9 0, 0 9))", "some.wkt"),
            "some.wkt:1: ring 0: does not end where it began; repeat its first point at its end");
  EXPECT_EQ(refusal("POINT (1 2 3)", "some.wkt"), "some.wkt:1: has a third coordinate; to ignore it, give --drop-z");
  EXPECT_EQ(refusal("POINT EMPTY", "some.wkt"), "some.wkt:1: is empty; leave the line out");
  EXPECT_EQ(refusal("CIRCLE (1 2)", "some.wkt"),
            "some.wkt:1: 'CIRCLE' is not read here; give POINT, LINESTRING, MULTILINESTRING, POLYGON or MULTIPOLYGON");
}

TEST(PlanarObjectsTest, Endings) {
  EXPECT_TRUE(is_planar("a/b.WKT"));
  EXPECT_TRUE(is_planar("b.geojson"));
  EXPECT_FALSE(is_planar("b.obj"));
  EXPECT_FALSE(is_planar("b"));
}

}  // namespace
}  // namespace sunder::io
