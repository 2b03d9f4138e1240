#include <sunder/ask/set/contact_row.h>

#include <sunder/planar/pair/segment_segment.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

namespace sunder::ask {
namespace {

using nlohmann::json;
using planar::Segment;
using planar::Segments;

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

ContactRow crossing() {
  return {0, 1, "crossing", {1, 1}, {}, {{"names", {"A", "B"}}, {"lines", {"1", "null"}, false}}};
}

TEST(ContactRow, InAReport) {
  EXPECT_EQ(report_text(crossing()), R"({"i": 0, "j": 1, "contact": "crossing", "point": [1.0, 1.0], )"
                                     R"("names": ["A", "B"], "lines": [1, null]})");
}

TEST(ContactRow, OnAMap) {
  EXPECT_EQ(json::parse(geojson_text(crossing(), 7)), json::parse(R"({
    "type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 1]},
    "properties": {"number": 7, "contact": "crossing", "i": 0, "j": 1, "names": ["A", "B"], "lines": [1, null]}})"));
}

TEST(ContactRow, AnOverlapIsItsCommonPart) {
  const Segments segments(std::vector{Segment{{0, 0}, {0, 3}}, Segment{{0, 5}, {0, 2}}, Segment{{0, 1}, {0, 2.5}}});
  const Segment part = common_part(segments[0], segments[1]);
  EXPECT_EQ(part, (Segment{{0, 2}, {0, 3}}));
  EXPECT_EQ(common_part(segments[1], segments[0]), part);
  EXPECT_EQ(common_part(segments[0], segments[2]), segments[2]);  // the one holds the other
  ContactRow row = crossing();
  row.part = {part.a, part.b};
  EXPECT_EQ(json::parse(geojson_text(row, 1))["geometry"],
            json::parse(R"({"type": "LineString", "coordinates": [[0, 2], [0, 3]]})"));
}

TEST(ContactRow, CoordinatesReadBackTheSame) {
  for (const double x : {0.1, 1e300, 5e-324, -std::numeric_limits<double>::max(), 0.30000000000000004}) {
    ContactRow row = crossing();
    row.point = {x, 1};
    const json feature = json::parse(geojson_text(row, 1));
    EXPECT_EQ(feature["geometry"]["coordinates"][0].get<double>(), x);
    EXPECT_EQ(json::parse(report_text(row))["point"][0].get<double>(), x);
  }
  ContactRow row = crossing();
  row.point = {0.1, 0};
  EXPECT_NE(geojson_text(row, 1).find("[0.1,0]"), std::string::npos);  // and no digit more
}

TEST(ContactRow, NamesMayBeAnything) {
  ContactRow row = crossing();
  row.properties[0].values = {"a \"quoted\\\" name\nof two lines", "\xff"};
  for (const std::string& text : {report_text(row), geojson_text(row, 1)}) {
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const json top = json::parse(text);
    const json names = top.contains("properties") ? top["properties"]["names"] : top["names"];
    EXPECT_EQ(names[0], row.properties[0].values[0]);
    EXPECT_EQ(names[1], "\xef\xbf\xbd");
  }
}

TEST(ContactRow, PropertiesThatWereAskedFor) {
  ContactRow row = crossing();
  const FeatureProperties of_i{{{"x, y", true}, {"1.5", false}}}, of_j{io::PropertyValues(2)};
  row.fields = fields_of({"a \"b\"", "size"}, of_i, 0, of_j, 0);
  const json expected = json::parse(R"({"a \"b\"": ["x, y", null], "size": [1.5, null]})");
  EXPECT_EQ(json::parse(report_text(row))["properties"], expected);
  EXPECT_EQ(json::parse(geojson_text(row, 1))["properties"]["properties"], expected);
  const std::string file = testing::TempDir() + "contact_row_fields_test.csv";
  ContactTable table(Talk(Sinks{}), file);
  table.add(row);
  table.close();
  EXPECT_EQ(read_text(file),
            "i,j,contact,x,y,name_i,name_j,line_i,line_j,\"a \"\"b\"\"_i\",\"a \"\"b\"\"_j\",size_i,size_j\r\n"
            "0,1,crossing,1,1,A,B,1,,\"x, y\",,1.5,\r\n");
  std::filesystem::remove(file);
}

TEST(ContactRow, AsATable) {
  const std::string file = testing::TempDir() + "contact_row_test.csv";
  ContactTable table(Talk(Sinks{}), file);
  ContactRow row = crossing();
  row.properties[0].values[1] = "a \"b\", c";
  row.properties.push_back({"shown_by", {"a vertex inside"}});
  table.add(row);
  table.add(row);
  table.close();
  EXPECT_EQ(read_text(file),
            "i,j,contact,x,y,name_i,name_j,line_i,line_j,shown_by\r\n"
            "0,1,crossing,1,1,A,\"a \"\"b\"\", c\",1,,a vertex inside\r\n"
            "0,1,crossing,1,1,A,\"a \"\"b\"\", c\",1,,a vertex inside\r\n");
  ContactTable empty(Talk(Sinks{}), file);
  empty.close();
  EXPECT_EQ(read_text(file), "i,j,contact,x,y\r\n");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace sunder::ask
