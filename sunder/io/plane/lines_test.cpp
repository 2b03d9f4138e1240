// What the reader of lines takes, and what it says of what it does not take.
#include <sunder/base/error.h>
#include <sunder/io/plane/lines.h>
#include <sunder/io/text/file.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace sunder::io {
namespace {

using planar::Segment;

const std::filesystem::path all_cases = tests::cases_folder(), line_cases = all_cases / "segments";

using Names = std::vector<std::string>;
using Numbers = std::vector<std::uint32_t>;

std::string line_error(const std::string& text, const std::string& place, const std::string& group = {},
                       ErrorCode code = ErrorCode::bad_file) {
  try {
    parse_lines(text, place, {false, group});
  } catch (const Error& problem) {
    EXPECT_EQ(problem.code(), code);
    return problem.what();
  }
  return "accepted";
}

TEST(LinesTest, Csv) {
  const LineFile file = read_lines(line_cases / "wires.csv");
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

TEST(LinesTest, IntervalsAreSegmentsOfTheAxis) {
  const LineFile file = parse_lines("team,High,low\na,3,1\nb,3,3\n", "a.csv", {.group = "team"});
  EXPECT_EQ(file.segments[0], (Segment{{1, 0}, {3, 0}}));
  EXPECT_EQ(file.segments[1], (Segment{{3, 0}, {3, 0}}));
  EXPECT_EQ(file.groups, (Names{"a", "b"}));
  EXPECT_EQ(parse_lines("low,high,x1,y1,x2,y2\n1,2,3,4,5,6\n", "a.csv").segments[0], (Segment{{3, 4}, {5, 6}}));
  EXPECT_THROW(parse_lines("low,top\n1,2\n", "a.csv"), Error);
  try {
    parse_lines("low,high\n1,2\n2,1\n", "a.csv");
    ADD_FAILURE();
  } catch (const Error& problem) {
    EXPECT_STREQ(problem.what(), "a.csv:3: low is greater than high; an interval is from low to high");
  }
}

TEST(LinesTest, CsvColumnsByName) {
  const LineFile file =
      parse_lines("width,name,X2,Y2,x1,y1,net\n7,a,3,4,1,2,GND\n8,,5,6,3,4,VCC\n", "a.csv", {.group = "net"});
  EXPECT_EQ(file.segments[0], (Segment{{1, 2}, {3, 4}}));
  EXPECT_EQ(file.segments[1], (Segment{{3, 4}, {5, 6}}));
  EXPECT_EQ(file.features, (Names{"a", "2"}));
  EXPECT_EQ(file.groups, (Names{"GND", "VCC"}));
  const std::string text = "x1,y1,x2,y2,net,id\n0,0,1,1,GND,a\n0,1,1,0,VCC,b\n";
  EXPECT_EQ(parse_lines(text, "a.csv").features, (Names{"a", "b"}));
  EXPECT_EQ(parse_lines(text, "a.csv", {.name = "net"}).features, (Names{"GND", "VCC"}));
  EXPECT_EQ(parse_lines("x1,y1,x2,y2,z1\n0,0,1,1,9\n", "a.csv", {.drop_z = true}).segments.size(), 1u);
  try {
    parse_lines(text, "a.csv", {.name = "use"});
    ADD_FAILURE();
  } catch (const Error& problem) {
    EXPECT_EQ(problem.code(), ErrorCode::bad_call);
    EXPECT_STREQ(problem.what(), "a.csv: there is no column 'use' to name by; there are net, id");
  }
}

TEST(LinesTest, CsvQuotedFields) {
  const LineFile file = parse_lines(
      "0,0,1,1,\"one, two\"\r\n0,1,1,2,\"say \"\"no\"\"\"\r\n\"0\" , 2,1,3, \" two\nlines \" \n5,5,6,6,\"\"\n",
      "a.csv");
  EXPECT_EQ(file.features, (Names{"one, two", "say \"no\"", "two\\x0alines", "4"}));
  EXPECT_EQ(file.source[2].line, 3u);
  EXPECT_EQ(file.source[3].line, 5u);
  EXPECT_EQ(parse_lines("0;0;1;1;a", "a.csv").segments.size(), 1u);
  EXPECT_EQ(parse_lines("0,0,1,1,\"a;b\"", "a.csv").features, Names{"a;b"});
}

// A geometry may go over several lines, hold nothing, and be a collection.
TEST(LinesTest, WktAsItComes) {
  const LineFile file = parse_lines(
      "POLYGON\r\n((0 0,\r\n 1\t0,\r\n0 1,0\r0))\n\nPOLYGON EMPTY\nGEOMETRYCOLLECTION (LINESTRING (0 0, 1 1),\n"
      "  GEOMETRYCOLLECTION (POLYGON ((5 5, 6 5, 5 6, 5 5))), MULTIPOLYGON EMPTY)\nMULTILINESTRING (EMPTY, (7 7, 8 "
      "8))\n"
      "MULTIPOLYGON Z EMPTY",
      "a.wkt");
  EXPECT_EQ(file.features, (Names{"1", "2", "3", "4", "5"}));
  ASSERT_EQ(file.segments.size(), 3u + 1 + 3 + 1);
  EXPECT_EQ(file.segments[2], (Segment{{0, 1}, {0, 0}}));
  const std::array<LineSource, 4> first{{{0, 1}, {2, 8}, {2, 8}, {3, 10}}};
  const std::array<std::size_t, 4> at{0, 3, 4, 7};
  for (std::size_t k = 0; k < at.size(); ++k) {
    EXPECT_EQ(file.source[at[k]].feature, first[k].feature) << k;
    EXPECT_EQ(file.source[at[k]].line, first[k].line) << k;
  }
  EXPECT_EQ(file.remarks, Names{"geometries that are null or empty: 4, the first of line 7; they hold nothing"});
  EXPECT_TRUE(file.left_out.empty());
}

TEST(LinesTest, OfAnotherKind) {
  const std::string wkt =
      "POINT (0 0)\nLINESTRING (0 0, 1 1)\nMULTIPOINT ((1 1),\n(2 2))\nGEOMETRYCOLLECTION (POINT (1 2), POLYGON ((5 5, "
      "6 "
      "5, 5 6, 5 5)))\nTRIANGLE ((0 0, 1 0, 0 1, 0 0))\n";
  const LineFile segments = parse_lines(wkt, "a.wkt", {.leave_out = true});
  EXPECT_EQ(segments.segments.size(), 4u);
  EXPECT_EQ(segments.features.size(), 5u);
  Names left_out;
  for (const LeftOut& l : segments.left_out) left_out.push_back(l.kind + " of " + l.of);
  EXPECT_EQ(left_out, (Names{"point of line 1", "point of line 3", "point of line 5", "TRIANGLE of line 6"}));
  const LineFile polygons = parse_lines(wkt, "a.wkt", {.lines = false, .leave_out = true});
  EXPECT_EQ(polygons.segments.size(), 3u);
  EXPECT_EQ(polygons.left_out.size(), 5u);
  EXPECT_EQ(parse_lines(wkt, "a.wkt", {.points = true, .leave_out = true}).segments.size(), 6u);
  const std::string json = R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "mast"}, "geometry": {"type": "Point", "coordinates": [5, 6]}},
    {"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}}]})";
  const LineFile file = parse_lines(json, "a.json", {.leave_out = true});
  EXPECT_EQ(file.left_out.at(0).of, "'mast'");
  EXPECT_EQ(file.source[0].feature, 1u);
  EXPECT_NE(line_error(json, "a.json")
                .find("a.json: feature 'mast': a point is not what is asked about; give a file without such, or ask "
                      "without them: "
                      "--leave-out"),
            std::string::npos);
}

TEST(LinesTest, NamesOfFeatures) {
  const auto feature = [](const std::string& members) {
    return R"({"type": "FeatureCollection", "features": [{"type": "Feature", )" + members +
           R"(, "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}}]})";
  };
  const auto name = [&](const std::string& members, const std::string& field = {}) {
    return parse_lines(feature(members), "a.json", {.name = field}).features.at(0);
  };
  EXPECT_EQ(name(R"("id": 7, "properties": {"NAME": "Chad", "id": "x", "POP": 3})"), "Chad");
  EXPECT_EQ(name(R"("id": 7, "properties": {"id": "x"})"), "7");
  EXPECT_EQ(name(R"("properties": {"ID": "x"})"), "x");
  EXPECT_EQ(name(R"("properties": {"name": null, "POP": 3})"), "1");
  EXPECT_EQ(name(R"("properties": {"NAME": "Chad", "POP": 3})", "POP"), "3");
  EXPECT_EQ(name(R"("id": 7, "properties": {"NAME": "Chad"})", "id"), "7");
  for (const auto& [text, place, message] :
       {std::array<std::string, 3>{feature(R"("properties": {"NAME": "Chad"})"), "a.json", "no feature has a property"},
        std::array<std::string, 3>{"LINESTRING (0 0, 1 1)", "a.wkt", "a.wkt: WKT has no fields to name features by"}}) {
    try {
      parse_lines(text, place, {.name = "use"});
      ADD_FAILURE() << text;
    } catch (const Error& problem) {
      EXPECT_EQ(problem.code(), ErrorCode::bad_call);
      EXPECT_NE(std::string(problem.what()).find(message), std::string::npos) << problem.what();
    }
  }
}

// Rings that are none are refused, or kept apart.
TEST(LinesTest, BrokenRings) {
  const std::string text =
      "POLYGON ((0 0, 1 0, 0 1, 1 1))\nMULTIPOLYGON (((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 1)), ((5 5, 6 5, 5 6, 5 "
      "5)))\n";
  EXPECT_NE(line_error(text, "a.wkt").find("a.wkt:1: ring 0: does not end where it began"), std::string::npos);
  const LineFile file = parse_lines(text, "a.wkt", {.keep_broken = true});
  ASSERT_EQ(file.broken.size(), 2u);
  EXPECT_EQ(file.broken[0].feature, 0u);
  EXPECT_EQ(file.broken[0].what, "ring 0: does not end where it began");
  EXPECT_EQ(file.broken[0].points.size(), 4u);
  EXPECT_EQ(file.broken[1].what, "polygon 0, ring 1: fewer than three different corners");
  EXPECT_EQ(file.broken[1].ring, 1u);
  EXPECT_EQ(file.broken[1].polygon, 1u);
  ASSERT_EQ(file.rings.size(), 2u);
  EXPECT_EQ(file.rings[0].polygon, 1u);
  EXPECT_EQ(file.rings[1].polygon, 2u);

  // A broken ring is a group of its own, where rings are grouped.
  const LineFile rings = parse_lines(text, "a.wkt", {.group = "ring", .keep_broken = true});
  EXPECT_EQ(rings.groups, (Names{"1, ring 0", "2, polygon 0, ring 0", "2, polygon 0, ring 1", "2, polygon 1, ring 0"}));
  EXPECT_EQ(rings.broken[0].group, 0u);
  EXPECT_EQ(rings.broken[1].group, 2u);
  EXPECT_EQ(parse_lines("POLYGON ((0 0, 1 0))", "a.wkt", {.group = "ring", .keep_broken = true}).groups,
            Names{"1, ring 0"});
}

TEST(LinesTest, ForeignFiles) {
  using namespace std::string_literals;
  const std::vector<std::array<std::string, 3>> files{
      {"a.shp", "\x00\x00\x27\x0a\x00"s,
       "this is a Shapefile, which is not read here; ogr2ogr -f GeoJSON OUT.geojson a.shp"},
      {"a.kml", "<?xml version=\"1.0\"?>\n<kml>", "this is KML, which is not read here; ogr2ogr"},
      {"a.gml", "<ogr:FeatureCollection>", "this is GML"},
      {"a.dxf", "999\r\nmade by\r\n  0\r\nSECTION\r\n", "this is DXF, which is not read here; ogr2ogr"},
      {"a.gds", "\x00\x06\x00\x02\x02\x58"s, "this is GDSII"},
      {"a.gpkg", "SQLite format 3\x00"s, "this is a GeoPackage"},
      {"b/a.csv.gz", "\x1f\x8b\x08",
       "this is a gzip archive, which is not read here; unpack it first: gunzip -k a.csv.gz"},
      {"a.csv", "\xff\xfe\x30\x00", "this is UTF-16 text (save it as UTF-8)"},
      {"a.csv", "0\x00,\x00"s, "this is a binary file"},
      {"a.csv", "\xff\xfe\x00\x00\x30\x00\x00\x00"s, "this is UTF-32 text (save it as UTF-8)"},
      {"a.csv", "\x00\x00\xfe\xff\x00\x00\x00\x30"s, "this is UTF-32 text (save it as UTF-8)"},
      {"a.gbr", "%FSLAX46Y46*%\n%MOMM*%\n", "this is a Gerber file, which is not read here; ask about the board"},
      {"a.gtl", "G04 layer 1*\n%MOIN*%\n", "this is a Gerber file"},
      {"a.drl", "M48\nMETRIC\n", "this is an Excellon drill file"},
      {"a.def", "VERSION 5.8 ;\nDIVIDERCHAR \"/\" ;\nDESIGN top ;\n", "this is DEF, which is not read here; write its"},
      {"a.lef", "VERSION 5.7 ;\nBUSBITCHARS \"[]\" ;\nMACRO a\n", "this is LEF"},
      {"a.brd", "<?xml version=\"1.0\"?>\n<!DOCTYPE eagle SYSTEM \"eagle.dtd\">\n<eagle version=\"9\">",
       "this is an Eagle board or schematic, which is not read here; open it in KiCad"},
      {"a.wkt", "0101000000000000000000F03F0000000000000040\n",
       "this is hexadecimal WKB, which is not read here; write WKT: SELECT ST_AsEWKT(geom)"},
      {"cube.obj", "# a cube\nv 0 0 0\n",
       "this is a mesh, which is not read here; ask sunder pair, scene, hull or info"},
      {"cube", "ply\nformat", "this is a mesh"}};
  for (const auto& [place, text, part] : files) {
    const std::string message = line_error(text, place);
    EXPECT_TRUE(message.starts_with(place + ": " + part)) << message;
  }
  EXPECT_EQ(line_error("0,0,1,1\n", "a.csv"), "accepted");
}

TEST(LinesTest, Wkt) {
  const LineFile file = read_lines(line_cases / "paths.wkt");
  EXPECT_EQ(file.format, "WKT");
  ASSERT_EQ(file.segments.size(), 2u + 1 + 2 + 4 + 3);
  EXPECT_EQ(file.segments[2], (Segment{{2, 2}, {4, 3}}));
  EXPECT_EQ(file.segments.back(), (Segment{{12, 2}, {11, 1}}));
  EXPECT_EQ(file.source.back().feature, 3u);
  EXPECT_EQ(file.source.back().line, 4u);
  EXPECT_EQ(parse_lines("multipolygon(((0 0,1 0,0 1,0 0)),((5 5,6 5,5 6,5 5)))", "x.wkt").segments.size(), 6u);
  EXPECT_EQ(parse_lines("LINESTRING Z (0 0 7, 1 1 7)", "x.wkt", {true, {}}).segments[0], (Segment{{0, 0}, {1, 1}}));
}

TEST(LinesTest, WktTags) {
  for (const std::string type :
       {"LINESTRINGZ", "linestringm", "LINESTRING ZM", "LineStringZM", "SRID=4326;LINESTRING Z"}) {
    const LineFile file = parse_lines(type + " (0 0 7, 1 1 7)", "x.wkt", {true, {}});
    EXPECT_EQ(file.segments[0], (Segment{{0, 0}, {1, 1}})) << type;
  }
  EXPECT_EQ(parse_lines("MULTIPOLYGONZ(((0 0 1,1 0 1,0 1 1,0 0 1)))", "x.wkt", {true, {}}).rings.size(), 1u);
  const LineFile file = parse_lines("srid = 1 ; LINESTRING (0 0, 1 1)\nLINESTRING (0 0, 2 1)", "-");
  EXPECT_EQ(file.segments.size(), 2u);
  EXPECT_TRUE(file.remarks.empty());
  EXPECT_EQ(file.systems.at(0).system.id, "EPSG:1");
}

TEST(LinesTest, GeoJson) {
  const LineFile file = read_lines(line_cases / "pond.geojson");
  EXPECT_EQ(file.format, "GeoJSON");
  ASSERT_EQ(file.segments.size(), 4u + 3 + 1);
  EXPECT_EQ(file.segments.back(), (Segment{{4, 9}, {4, 6}}));
  EXPECT_EQ(file.features, (std::vector<std::string>{"pond", "jetty"}));
  EXPECT_EQ(file.source.back().line, 0u);
  const std::string collection =
      R"({"type": "GeometryCollection", "geometries": [{"type": "LineString", "coordinates": [[0, 0, 5], [1, 1, 5]]},
          {"type": "MultiPolygon", "coordinates": [[[[0, 0], [1, 0], [0, 1], [0, 0]]]]}]})";
  EXPECT_EQ(parse_lines(collection, "-", {true, {}}).segments.size(), 4u);
}

TEST(LinesTest, FeaturesWithoutGeometry) {
  const std::string line =
      R"({"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}})";
  const std::string null = R"({"type": "Feature", "geometry": null, "properties": null})";
  const LineFile file =
      parse_lines(R"({"type": "FeatureCollection", "features": [)" + null + "," + line + "," + null + "]}", "a.json");
  EXPECT_EQ(file.features, (Names{"1", "2", "3"}));
  EXPECT_EQ(file.source[0].feature, 1u);
  EXPECT_EQ(file.remarks, Names{"geometries that are null or empty: 2, the first of '1'; they hold nothing"});
  EXPECT_EQ(parse_lines(line, "a.json").remarks, Names{});
}

TEST(LinesTest, KeysMayRepeatInDifferentObjects) {
  const std::string line =
      R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]], "a": {"a": {"type": 0}, "type": 0}})";
  EXPECT_EQ(
      parse_lines(R"({"type": "GeometryCollection", "geometries": [)" + line + "," + line + "]}", "-").segments.size(),
      2u);
}

TEST(LinesTest, GroupsOfCsv) {
  const std::string text = "x1,y1,x2,y2,net,id,\"layer\"\n0,0,1,1,GND,a,1\n0,1,1,0,VCC,b,1\n\n2,2,3,3,GND,,2\n";
  const LineFile net = parse_lines(text, "a.csv", {false, "net"});
  EXPECT_EQ(net.groups, (Names{"GND", "VCC"}));
  EXPECT_EQ(net.group, (Numbers{0, 1, 0}));
  EXPECT_EQ(net.features, (Names{"a", "b", "3"}));
  EXPECT_EQ(parse_lines(text, "a.csv", {false, "layer"}).group, (Numbers{0, 0, 1}));
  EXPECT_EQ(parse_lines(text, "a.csv", {false, "feature"}).group, (Numbers{0, 1, 2}));
  EXPECT_EQ(parse_lines("0;0;1;1;a\n0;1;1;0;a\n", "a.csv", {false, "feature"}).groups, (Names{"a", "a"}));
  EXPECT_EQ(parse_lines("x1;y1;x2;y2;feature\n0;0;1;1;a\n0;1;1;0;a\n", "a.csv", {false, "feature"}).groups, Names{"a"});
  const LineFile none = read_lines(line_cases / "wires.csv");
  EXPECT_TRUE(none.group.empty() && none.groups.empty() && none.layer.empty() && none.layers.empty());
  EXPECT_EQ(line_error(text, "a.csv", "ring", ErrorCode::bad_call),
            "a.csv: there is no column 'ring' to group by; there are net, id, layer");
  EXPECT_EQ(line_error("0,0,1,1,a\n", "a.csv", "net", ErrorCode::bad_call),
            "a.csv: there is no column 'net' to group by; a first line has to name the columns after x1,y1,x2,y2");
  EXPECT_NE(line_error("x1,y1,x2,y2,net,net\n", "a.csv", "net").find("a.csv:1: two columns are named 'net'"),
            std::string::npos);
  EXPECT_NE(line_error("x1,y1,x2,y2,id,net\n0,0,1,1,a\n", "a.csv", "net")
                .find("a.csv:2: has 5 fields, but the line of names has 6"),
            std::string::npos);
  EXPECT_NE(line_error("x1,y1,x2,y2,net\n0,0,1,1,\n", "a.csv", "net").find("a.csv:2: has no value in the column 'net'"),
            std::string::npos);
  EXPECT_NE(line_error("0,0,1,1,a,b\n", "a.csv", "feature").find("a.csv:1: has 6 fields"), std::string::npos);
}

TEST(LinesTest, GroupsOfWkt) {
  const std::string text =
      "LINESTRING (0 0, 1 0, 2 0)\nMULTILINESTRING ((0 1, 1 1), (0 2, 1 2))\n"
      "MULTIPOLYGON (((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1)), ((5 5, 6 5, 5 6, 5 5)))\n";
  const LineFile feature = parse_lines(text, "a.wkt", {false, "feature"});
  EXPECT_EQ(feature.groups, (Names{"1", "2", "3"}));
  EXPECT_EQ(feature.group, (Numbers{0, 0, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2}));
  const LineFile ring = parse_lines(text, "a.wkt", {false, "ring"});
  EXPECT_EQ(ring.groups, (Names{"1, line 0", "2, line 0", "2, line 1", "3, polygon 0, ring 0", "3, polygon 0, ring 1",
                                "3, polygon 1, ring 0"}));
  EXPECT_EQ(ring.group, (Numbers{0, 0, 1, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5}));
  EXPECT_EQ(line_error(text, "a.wkt", "net", ErrorCode::bad_call),
            "a.wkt: there is no field 'net' to group by; there are feature, ring");
}

TEST(LinesTest, GroupsOfGeoJson) {
  const auto feature = [](const std::string& properties) {
    return R"({"type": "Feature", "properties": )" + properties +
           R"(, "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}})";
  };
  const auto collection = [&](const Names& properties) {
    std::string list;
    for (const std::string& p : properties) list += (list.empty() ? "" : ", ") + feature(p);
    return R"({"type": "FeatureCollection", "features": [)" + list + "]}";
  };
  const std::string text =
      collection({R"({"use": "farm"})", R"({"use": 7})", R"({"use": true})", R"({"use": "farm"})", R"({"use": "7"})"});
  const LineFile use = parse_lines(text, "a.json", {false, "use"});
  EXPECT_EQ(use.groups, (Names{"farm", "7", "true"}));
  EXPECT_EQ(use.group, (Numbers{0, 0, 0, 1, 1, 1, 2, 2, 2, 0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(parse_lines(text, "a.json", {false, "feature"}).groups, (Names{"1", "2", "3", "4", "5"}));
  const LineFile pond = read_lines(line_cases / "pond.geojson", {false, "ring"});
  EXPECT_EQ(pond.groups, (Names{"pond, ring 0", "pond, ring 1", "jetty, line 0"}));
  const std::string rings = "[[[0, 0], [4, 0], [4, 4]], [[1, 1], [2, 1], [2, 2]]]";
  EXPECT_EQ(parse_lines(rings, "a.json", {false, "ring"}).groups, (Names{"1, ring 0", "1, ring 1"}));
  EXPECT_EQ(line_error(rings, "a.json", "use", ErrorCode::bad_call),
            "a.json: there is no field 'use' to group by; there are feature, ring");
  for (const std::string properties : {R"({"name": "b"})", "null", "[]"}) {
    const std::string message = line_error(collection({R"({"use": "farm"})", properties}), "a.json", "use");
    EXPECT_NE(message.find(": has no property 'use'; give it one, or group by feature or ring"), std::string::npos)
        << message;
  }
  EXPECT_NE(line_error(collection({R"({"name": "b", "use": []})"}), "a.json", "use")
                .find("a.json: feature 'b': property 'use' is neither text nor a number"),
            std::string::npos);
  EXPECT_NE(line_error(R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})", "a.json", "use")
                .find("feature '1': has no"),
            std::string::npos);
}

TEST(LinesTest, Properties) {
  const std::string features = R"({"type": "FeatureCollection", "features": [
      {"type": "Feature", "properties": {"use": "a\nb", "size": 1.50, "is": true, "of": {"x": 1}},
       "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1], [2, 2]]}},
      {"type": "Feature", "properties": null, "geometry": null},
      {"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}}]})";
  const LineFile file = parse_lines(features, "a.geojson", {.properties = {"size", "use", "of", "is"}});
  const PropertyValues none(4);
  EXPECT_EQ(none[0], (PropertyValue{"null", false}));
  EXPECT_EQ(file.properties,
            (std::vector<PropertyValues>{
                {{"1.5", false}, {"a\\x0ab", true}, {R"({"x":1})", true}, {"true", false}}, none, none}));
  EXPECT_TRUE(parse_lines(features, "a.geojson").properties.empty());
  const auto refused = [](const std::string& text, const std::string& place) {
    try {
      parse_lines(text, place, {.properties = {"use", "colour"}});
    } catch (const Error& problem) {
      EXPECT_EQ(problem.code(), ErrorCode::bad_call);
      return std::string(problem.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refused(features, "a.geojson"),
            "a.geojson: there is no property 'colour' to tell of; there are is, of, size, use");
  EXPECT_EQ(refused(R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})", "a.geojson"),
            "a.geojson: there is no property 'use' to tell of; there is none");
  EXPECT_EQ(refused("x1,y1,x2,y2,use\n0,0,1,1,a\n", "a.csv"),
            "a.csv: there is no column 'colour' to tell of; there are use");
  EXPECT_EQ(refused("LINESTRING (0 0, 1 1)", "a.wkt"), "a.wkt: WKT has no properties to tell of; leave them out");
  EXPECT_EQ(parse_lines("x1,y1,x2,y2,use\n0,0,1,1\n", "a.csv", {.properties = {"use"}}).properties,
            std::vector<PropertyValues>{{PropertyValue{}}});
}

TEST(LinesTest, Rings) {
  const auto rings = [](const LineFile& file) {
    std::vector<std::array<std::uint32_t, 3>> found;
    for (const LineRing& r : file.rings) found.push_back({r.first, r.count, r.polygon});
    return found;
  };
  using Rings = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(rings(read_lines(line_cases / "wires.csv")), Rings{});
  EXPECT_EQ(rings(read_lines(line_cases / "paths.wkt")), (Rings{{5, 4, 0}, {9, 3, 0}}));
  EXPECT_EQ(rings(read_lines(line_cases / "pond.geojson")), (Rings{{0, 4, 0}, {4, 3, 0}}));
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
  EXPECT_NE(line_error(text, "a.json").find("nested 100 deep"), std::string::npos);
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
      {"a.csv", "x1,y1,z1,x2,y2,z2\n0,0,0,1,1,0\n", "a.csv:1: has a third coordinate, 'z1'; to ignore it, give"},
      {"a.csv", "x,y,r,name\n1,0,0,b\n", "a.csv:1: the columns are named x,y,r,name, but segments have x1,y1,x2,y2"},
      {"a.csv", "x1,y1,x2,Y2,y2\n1,0,0,5,5\n", "a.csv:1: two columns are named 'y2'"},
      {"a.csv", "0,0,1,1,\"a,b\n2,2,3,3\n", "a.csv:1: a quote is opened and not closed"},
      {"a.wkt", "LINESTRING (0 0, 1 1\n", "a.wkt:1: ends where ')' is expected"},
      {"a.wkt", "LINESTRING (0 0)\n", "a.wkt:1: a line has fewer than two points"},
      {"a.wkt", "LINESTRING (0 0, 1)\n", "a.wkt:1: a point has two numbers"},
      {"a.wkt", "LINESTRING (0 0 0, 1 1 1)\n", "--drop-z"},
      {"a.wkt", "LINESTRING EMPTY\n", "a.wkt: has no segments"},
      {"a.wkt", "POLYGON ((0 0, 1 0,\n0 1, 0 0)\nPOLYGON ((0 0, 1 0, 0 1, 0 0))",
       "a.wkt:3: 'POLYGON ((0 0, 1 0, 0 1, 0 0))' stands where ')' is expected, in the geometry that begins on line 1"},
      {"a.wkt", "MULTIPOINT (0 0)\n", "a.wkt:1: a point is not what is asked about"},
      {"a.wkt", "TIN (((0 0, 1 0, 0 1, 0 0)))\n", "a.wkt:1: a TIN is not what is asked about"},
      {"a.wkt", "LINESTRING (0 0, 1 1)\n\nPOINT (0\n x)\n", "a.wkt:3: a point is not what is asked about"},
      {"a.wkt", "LINESTRING (0 0, 1 1)\n\nPOLYGON ((0\n x))\n", "a.wkt:4: ring 0: 'x' is not a number"},
      {"a.wkt", "MULTILINESTRING (NOTHING)\n", "'NOTHING' stands where '(' or EMPTY is expected"},
      {"a.wkt", "LINESTRING (0 0, inf 1)\n", "'inf' is infinite"},
      {"a.wkt", "LINESTRING (0 0, 1 1) x\n", "'x' stands after"},
      {"a.wkt", "POINT (0 0)\n", "a.wkt:1: a point is not what is asked about"},
      {"a.wkt", "POLYGON ((0 0, 1 0, 0 1, 1 1))\n", "does not end where it began"},
      {"a.wkt", "POLYGON ((0 0, 1 0, 0 0))\n", "a.wkt:1: ring 0: fewer than three different corners"},
      {"a.wkt", "LINESTRING (0 0, 1 1)\nLINESTRING 0 0\n", "a.wkt:2: '0 0' stands where '(' is expected"},
      {"a.json", "{\"type\": \"LineString\", \n \"coordinates\": [[0, 0], [1, 1]",
       "a.json: is not JSON that can be read: at line 2, column"},
      {"a.json", R"({"type": "LineString", "coordinates": [[0, 0], [1, 1e999]]})", "number overflow"},
      {"a.json", "[1, 2]", "an object with a \"type\" is expected"},
      {"a.json", R"({"type": "Point", "coordinates": [0, 0]})", "feature '1': a point is not what is asked about"},
      {"a.json", R"({"type": "FeatureCollection"})", "no list \"features\""},
      {"a.json", R"({"type": "Feature", "id": 7})", "feature '7': has no \"geometry\""},
      {"a.json", R"({"type": "LineString", "coordinates": [[0, 0], ["1", 1]]})", "not a list of two numbers"},
      {"a.json", R"({"type": "LineString", "coordinates": [[0, 0, 1], [1, 1, 1]]})", "--drop-z"},
      {"a.json", R"({"type": "Polygon", "coordinates": [[0, 0], [1, 1]]})", "not a list of two numbers"},
      {"a.json", R"({"type": "MultiPolygon", "coordinates": [5]})", "depth"},
      {"a.json", R"({"type": "Polygon", "coordinates": []})", "a.json: has no segments"},
      {"a.json", R"({"type": "Polygon", "coordinates": [[]]})", "a.json: has no segments"},
      {"a.json", R"({"type": "Circle", "coordinates": [0, 0]})", "'Circle' is not one of GeoJSON"},
      {"a.json", R"({"type": "Topology", "objects": {}})", "is TopoJSON, which is not read; make GeoJSON of it: ogr"},
      {"a.json", R"({"type": "Feature", "geometry": {"type": "Polygon"}})", "has no list \"coordinates\""},

  };
  for (const auto& [place, text, part] : wrong) {
    const std::string message = line_error(text, place);
    EXPECT_NE(message.find(part), std::string::npos) << text << "\n" << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(message.starts_with(place)) << message;
  }
}

TEST(LinesTest, RefusesEveryBrokenFile) {
  const std::filesystem::path folder = all_cases / "broken-lines";
  std::set<std::string> seen{"EXPECTED.tsv", "README.md"}, found;
  std::istringstream table(read_file(folder / "EXPECTED.tsv"));
  for (std::string row; std::getline(table, row);) {
    if (row.starts_with('#')) continue;
    const std::size_t tab = row.find('\t');
    ASSERT_NE(tab, std::string::npos) << row;
    const std::string name = row.substr(0, tab), part = row.substr(tab + 1);
    SCOPED_TRACE(name);
    EXPECT_TRUE(seen.insert(name).second) << "twice in the table";
    const std::string path = (folder / name).string(), message = line_error(read_file(path), path);
    EXPECT_TRUE(message.starts_with(path + part)) << "expected: " << part << "\nmessage: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LT(message.size(), path.size() + 300) << message;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) found.insert(entry.path().filename().string());
  EXPECT_EQ(seen, found) << "EXPECTED.tsv and the folder differ";
  EXPECT_GE(seen.size(), 40u);
}

// Any beginning of a file is read or refused with an error of one line, never a crash.
TEST(LinesTest, SurvivesTruncationAnywhere) {
  int refused = 0, all = 0;
  for (const std::string name :
       {"segments/pond.geojson", "segments/paths.wkt", "segments/wires.csv", "boards/two_nets.kicad_pcb"}) {
    const std::string text = read_file(all_cases / name);
    for (std::size_t size = 0; size < text.size(); ++size, ++all) {
      const std::string message = line_error(text.substr(0, size), name);
      if (message == "accepted") continue;
      ++refused;
      EXPECT_TRUE(message.starts_with(name) && message.find('\n') == std::string::npos) << message;
    }
  }
  EXPECT_GT(refused, all / 2);
}

TEST(LinesTest, FormatsAreToldByEndingThenByFirstLetters) {
  constexpr std::string_view table = "x1,y1,x2,y2 (m)\n", text = " LINESTRING (0 0, 1 1)\n", json = "\n{\"type\": 1}";
  EXPECT_EQ(lines_format(table, "-"), LinesFormat::csv);
  EXPECT_EQ(lines_format("0,0,1,1\n", "-"), LinesFormat::csv);
  EXPECT_EQ(lines_format("", "-"), LinesFormat::csv);
  EXPECT_EQ(lines_format(text, "-"), LinesFormat::wkt);
  EXPECT_EQ(lines_format(json, "data.txt"), LinesFormat::geojson);
  EXPECT_EQ(lines_format("[[0, 0]]", "-"), LinesFormat::geojson);
  EXPECT_EQ(lines_format(json, "a.CSV"), LinesFormat::csv);
  EXPECT_EQ(lines_format(json, "a.wkt"), LinesFormat::wkt);
  EXPECT_EQ(lines_format(table, "a.json"), LinesFormat::geojson);
}

}  // namespace
}  // namespace sunder::io
