#include <sunder/base/json.h>
#include <sunder/base/json_line.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace sunder {
namespace {

TEST(JsonLine, WritesAsValuesDo) {
  std::string line = "before ";
  JsonLine json(line);
  json.open('{')
      .member("text", "a \"quoted\" one")
      .member("true", true)
      .member("number", 0.1)
      .member("none", std::numeric_limits<double>::quiet_NaN());
  json.key("list").open('[').value(std::uint32_t{7}).open('{').close('}').written("null").close(']');
  json.member("numbers", std::array{std::array{1.0, -0.0}, std::array{1e20, 2.5}}).member("last", std::size_t{12});
  json.close('}');
  const Json value{{"text", "a \"quoted\" one"},
                   {"true", true},
                   {"number", 0.1},
                   {"none", nullptr},
                   {"list", Json::array({7, Json::object(), nullptr})},
                   {"numbers", Json::array({Json::array({1.0, -0.0}), Json::array({1e20, 2.5})})},
                   {"last", 12}};
  EXPECT_EQ(line, "before " + value.on_one_line());
}

}  // namespace
}  // namespace sunder
