#include <cli/contacts_geojson.h>

#include <sunder/planar/pair/segment_segment.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::cli {
namespace {

using nlohmann::json;
using planar::Segment;
using planar::Segments;

std::string text_of(const io::LineFile& file) {
  const Segments segments(file.segments);
  std::vector<planar::SegmentsContact> contacts = planar::segments_all(segments).contacts;
  std::sort(contacts.begin(), contacts.end());
  std::string text;
  ContactsGeojson geojson(file, [&](std::string_view piece) { text += piece; });
  for (const planar::SegmentsContact& contact : contacts) geojson.add(contact);
  geojson.close();
  return text;
}

std::string text_of(const std::string& csv) { return text_of(io::parse_lines(csv, "t.csv")); }

TEST(ContactsGeojson, ACrossing) {
  const json map = json::parse(text_of("0,0,2,2,A\n0,2,2,0,B\n"));
  EXPECT_EQ(map["type"], "FeatureCollection");
  ASSERT_EQ(map["features"].size(), 1u);
  EXPECT_EQ(map["features"][0], json::parse(R"({
    "type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 1]},
    "properties": {"number": 1, "kind": "crossing", "i": 0, "j": 1, "features": ["A", "B"], "lines": [1, 2]}})"));
}

TEST(ContactsGeojson, AnOverlapIsItsCommonPart) {
  const json feature = json::parse(text_of("0,0,3,3\n5,5,1,1\n"))["features"][0];
  EXPECT_EQ(feature["geometry"], json::parse(R"({"type": "LineString", "coordinates": [[1, 1], [3, 3]]})"));
  EXPECT_EQ(feature["properties"]["kind"], "overlap");
}

TEST(ContactsGeojson, CommonPart) {
  const Segments segments(std::vector{Segment{{0, 0}, {0, 3}}, Segment{{0, 5}, {0, 2}}, Segment{{0, 1}, {0, 2.5}}});
  EXPECT_EQ(common_part(segments[0], segments[1]), (Segment{{0, 2}, {0, 3}}));
  EXPECT_EQ(common_part(segments[1], segments[0]), (Segment{{0, 2}, {0, 3}}));
  EXPECT_EQ(common_part(segments[0], segments[2]), segments[2]);  // the one holds the other
}

TEST(ContactsGeojson, NoContacts) {
  EXPECT_EQ(text_of("0,0,1,0\n0,1,1,1\n"), "{\"type\":\"FeatureCollection\",\"features\":[\n]}\n");
}

TEST(ContactsGeojson, AFeatureIsALine) {
  const std::string text = text_of("0,0,4,0\n1,-1,1,1\n2,-1,2,1\n");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  const json map = json::parse(text);
  ASSERT_EQ(map["features"].size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(map["features"][k]["properties"]["number"], k + 1);
}

TEST(ContactsGeojson, CoordinatesReadBackTheSame) {
  const std::string csv = "0.1,0.2,0.7,0.3\n0.3,0.9,0.3,-0.1\n-1e300,1e-300,1e300,1e-300\n0.7,0.3,5e-324,1e300\n";
  const io::LineFile file = io::parse_lines(csv, "t.csv");
  const Segments segments(file.segments);
  const json map = json::parse(text_of(csv));
  ASSERT_GE(map["features"].size(), 3u);
  for (const json& feature : map["features"]) {
    const std::uint32_t i = feature["properties"]["i"], j = feature["properties"]["j"];
    const Point2 p = planar::common_point_rounded(segments[i], segments[j]);
    ASSERT_EQ(feature["geometry"]["type"], "Point");
    EXPECT_EQ(feature["geometry"]["coordinates"][0].get<double>(), p.x);
    EXPECT_EQ(feature["geometry"]["coordinates"][1].get<double>(), p.y);
  }
  EXPECT_NE(text_of("0,0,0.2,0\n0.1,-1,0.1,1\n").find("[0.1,0]"), std::string::npos);  // and no digit more
}

TEST(ContactsGeojson, NamesMayBeAnything) {
  io::LineFile file = io::parse_lines("0,0,2,2,A\n0,2,2,0,B\n", "t.csv");
  file.features = {"a \"quoted\\\" name\nof two lines", "\xff"};
  const std::string text = text_of(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  const json names = json::parse(text)["features"][0]["properties"]["features"];
  EXPECT_EQ(names[0], file.features[0]);
  EXPECT_EQ(names[1], "\xef\xbf\xbd");
}

TEST(ContactsGeojson, LinesGroupsAndLayers) {
  const std::string geojson = R"({"type": "MultiLineString", "coordinates": [[[0, 0], [2, 2]], [[0, 2], [2, 0]]]})";
  const json properties = json::parse(text_of(io::parse_lines(geojson, "t.json")))["features"][0]["properties"];
  EXPECT_EQ(properties["lines"], json::parse("[null, null]"));
  EXPECT_FALSE(properties.contains("groups"));
  EXPECT_FALSE(properties.contains("layers"));

  io::LineFile file = io::parse_lines("0,0,2,2,A\n0,2,2,0,B\n", "t.csv");
  file.groups = {"GND", "VCC"};
  file.group = {1, 0};
  file.layers = {"F.Cu"};
  file.layer = {0, 0};
  const json of_board = json::parse(text_of(file))["features"][0]["properties"];
  EXPECT_EQ(of_board["groups"], json::parse(R"(["VCC", "GND"])"));
  EXPECT_EQ(of_board["layers"], json::parse(R"(["F.Cu", "F.Cu"])"));
}

}  // namespace
}  // namespace sunder::cli
