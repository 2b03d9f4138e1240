// The text of JSON values, against another library's.
#include <sunder/base/json.h>
#include <sunder/base/random.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <limits>

namespace sunder {
namespace {

TEST(Json, BracedListsAreObjectsOrArrays) {
  EXPECT_EQ(Json().compact(), "null");
  EXPECT_EQ(Json({}).compact(), "{}");
  EXPECT_EQ((Json{{"a", 1}, {"b", {2, 3u}}}).compact(), R"({"a":1,"b":[2,3]})");
  EXPECT_EQ((Json{{"a", 1}, {2, "b"}}).compact(), R"([["a",1],[2,"b"]])");
  EXPECT_EQ(Json::array({{"a", 1}}).compact(), R"([["a",1]])");
  EXPECT_EQ(Json::array({{{"a", 1}}}).compact(), R"([{"a":1}])");
  EXPECT_EQ((Json{{"a", nullptr}, {"b", true}, {"c", -7}, {"d", "x"}}).on_one_line(),
            R"({"a": null, "b": true, "c": -7, "d": "x"})");
  EXPECT_EQ(Json(std::vector<std::string>{"a", "b"}).compact(), R"(["a","b"])");
}

TEST(Json, MembersKeepTheirOrder) {
  Json json;
  json["z"] = 1;
  json["a"]["b"] = Json::written("1e3");
  json["z"] = false;
  json.update({{"y", 2}, {"z", 3}});
  EXPECT_EQ(json.compact(), R"({"z":3,"a":{"b":1e3},"y":2})");
  json.erase("z");
  json.erase("none");
  json["y"] = Json();
  json["y"].push_back({1, 2});
  EXPECT_EQ(json.compact(), R"({"a":{"b":1e3},"y":[[1,2]]})");
}

TEST(Json, Integers) {
  EXPECT_EQ(Json(std::numeric_limits<std::int64_t>::min()).compact(), "-9223372036854775808");
  EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).compact(), "18446744073709551615");
}

TEST(Json, NumbersAreReadAsTheyWere) {
  for (const double x : {0.0, -0.0, 1.0, -1.5, 0.1, 1e-4, 1e-5, 123456789012345.0, 1234567890123456.0, 1e15, 1e16, 1e22,
                         5e-324, 1.7976931348623157e308, 0.00012345, 100.0, 12.5}) {
    EXPECT_EQ(json_number(x), nlohmann::json(x).dump()) << x;
  }
  EXPECT_EQ(Json(std::numeric_limits<double>::infinity()).compact(), "null");
  Random random(7);
  for (int k = 0; k < 20000; ++k) {
    const double x = std::bit_cast<double>(random.next());
    if (x != x || x - x != 0) continue;
    const std::string text = json_number(x);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(nlohmann::json::parse(text).get<double>()), std::bit_cast<std::uint64_t>(x));
    ASSERT_LE(text.size(), nlohmann::json(x).dump().size());
  }
}

TEST(Json, TextIsReadAsItWas) {
  const std::string text = "a\"b\\c\n\t\x01\x7f\xc3\xa4\xe2\x80\xae\xf0\x9f\x98\x80";
  EXPECT_EQ(nlohmann::json::parse(json_string(text)).get<std::string>(), text);
  EXPECT_EQ(json_string("a\xff\xc3\xa4"), "\"a\\ufffd\xc3\xa4\"");
}

}  // namespace
}  // namespace sunder
