// What the reader of lines takes, and what it says of what it does not take.
#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/lines.h>

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

const std::filesystem::path all_cases = SUNDER_CASES_DIR, cases = all_cases / "segments";

using Names = std::vector<std::string>;
using Numbers = std::vector<std::uint32_t>;

std::string error(const std::string& text, const std::string& place, const std::string& group = {},
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
  EXPECT_EQ(file.remarks, Names{"lines with an SRID: 1; it is passed over: coordinates count as those of a plane"});
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
  EXPECT_EQ(parse_lines(collection, "-", {true, {}}).segments.size(), 4u);
}

TEST(LinesTest, FeaturesWithoutGeometry) {
  const std::string line =
      R"({"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}})";
  const std::string null = R"({"type": "Feature", "geometry": null, "properties": null})";
  const LineFile file =
      parse_lines(R"({"type": "FeatureCollection", "features": [)" + null + "," + line + "," + null + "]}", "a.json");
  EXPECT_EQ(file.features, Names{"2"});
  EXPECT_EQ(file.remarks, Names{"features without a geometry, passed over: 2"});
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
  EXPECT_EQ(parse_lines("x;y;x;y;feature\n0;0;1;1;a\n0;1;1;0;a\n", "a.csv", {false, "feature"}).groups, Names{"a"});
  const LineFile none = read_lines(cases / "wires.csv");
  EXPECT_TRUE(none.group.empty() && none.groups.empty() && none.layer.empty() && none.layers.empty());
  EXPECT_EQ(error(text, "a.csv", "ring", ErrorCode::bad_call),
            "a.csv: there is no field 'ring' to group by; there are feature, net, id, layer");
  EXPECT_EQ(error("0,0,1,1,a\n", "a.csv", "net", ErrorCode::bad_call),
            "a.csv: there is no field 'net' to group by; there are feature, and the columns after the fourth where a "
            "first line names them");
  EXPECT_NE(error("x,y,x,y,net,net\n", "a.csv", "net").find("a.csv:1: two columns are named 'net'"), std::string::npos);
  EXPECT_NE(
      error("x,y,x,y,id,net\n0,0,1,1,a\n", "a.csv", "net").find("a.csv:2: has 5 fields, but the line of names has 6"),
      std::string::npos);
  EXPECT_NE(error("x,y,x,y,net\n0,0,1,1,\n", "a.csv", "net").find("a.csv:2: has no value in the column 'net'"),
            std::string::npos);
  EXPECT_NE(error("0,0,1,1,a,b\n", "a.csv", "feature").find("a.csv:1: has 6 fields"), std::string::npos);
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
  EXPECT_EQ(error(text, "a.wkt", "net", ErrorCode::bad_call),
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
  const LineFile pond = read_lines(cases / "pond.geojson", {false, "ring"});
  EXPECT_EQ(pond.groups, (Names{"pond, ring 0", "pond, ring 1", "jetty, line 0"}));
  const std::string rings = "[[[0, 0], [4, 0], [4, 4]], [[1, 1], [2, 1], [2, 2]]]";
  EXPECT_EQ(parse_lines(rings, "a.json", {false, "ring"}).groups, (Names{"1, ring 0", "1, ring 1"}));
  EXPECT_EQ(error(rings, "a.json", "use", ErrorCode::bad_call),
            "a.json: there is no field 'use' to group by; there are feature, ring");
  for (const std::string properties : {R"({"name": "b"})", "null", "[]"}) {
    const std::string message = error(collection({R"({"use": "farm"})", properties}), "a.json", "use");
    EXPECT_NE(message.find(": has no property 'use'; give it one, or group by feature or ring"), std::string::npos)
        << message;
  }
  EXPECT_NE(error(collection({R"({"name": "b", "use": []})"}), "a.json", "use")
                .find("a.json: feature 'b': property 'use' is neither text nor a number"),
            std::string::npos);
  EXPECT_NE(
      error(R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})", "a.json", "use").find("feature '1': has no"),
      std::string::npos);
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
      {"a.wkt", "POLYGON ((0 0, 1 0, 0 0))\n", "a.wkt:1: ring 0: fewer than three different corners"},
      {"a.wkt", "LINESTRING (0 0, 1 1)\nLINESTRING 0 0\n", "a.wkt:2: '0 0' stands where '(' is expected"},
      {"a.json", "{\"type\": \"LineString\", \n \"coordinates\": [[0, 0], [1, 1]",
       "a.json: is not JSON that can be read: at line 2, column"},
      {"a.json", R"({"type": "LineString", "coordinates": [[0, 0], [1, 1e999]]})", "number overflow"},
      {"a.json", "[1, 2]", "an object with a \"type\" is expected"},
      {"a.json", R"({"type": "Point", "coordinates": [0, 0]})", "'Point' has no segments"},
      {"a.json", R"({"type": "FeatureCollection"})", "no list \"features\""},
      {"a.json", R"({"type": "Feature", "id": 7})", "feature '7': has no \"geometry\""},
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
    const std::string path = (folder / name).string(), message = error(read_file(path), path);
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
      const std::string message = error(text.substr(0, size), name);
      if (message == "accepted") continue;
      ++refused;
      EXPECT_TRUE(message.starts_with(name) && message.find('\n') == std::string::npos) << message;
    }
  }
  EXPECT_GT(refused, all / 2);
}

}  // namespace
}  // namespace sunder::io
