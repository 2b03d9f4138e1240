// Numbers, points and bodies with a radius out of JSON trees, for readers of small files: each with its place.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/round/round_body.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// Each `where` is the place of a value in the file, such as "bodies[1].pose", for messages. -0 is read as 0.
// All throw Error bad_file "FILE: WHERE: what is wrong; remedy".
class JsonShapes {
 public:
  using Json = nlohmann::json;
  using Keys = std::initializer_list<std::string_view>;

  explicit JsonShapes(std::string_view file) : file_(file) {}

  [[noreturn]] void fail(const std::string& where, const std::string& what) const;

  // An object, with no keys but these.
  void require_keys(const Json& value, const std::string& where, Keys known) const;
  // What stands at the key of such an object. Requires `key` among the known.
  const Json& member(const Json& value, const std::string& where, const std::string& key, Keys known) const;

  double number(const Json& value, const std::string& where) const;
  template <std::size_t N>
  std::array<double, N> numbers(const Json& value, const std::string& where, const char* form) const {
    if (!value.is_array() || value.size() != N) fail(where, fmt::format("is no list {} of {} numbers", form, N));
    std::array<double, N> result;
    for (std::size_t k = 0; k < N; ++k) result[k] = number(value[k], where);
    return result;
  }
  Point3 point(const Json& value, const std::string& where) const;
  std::vector<Point3> points(const Json& value, const std::string& where) const;

  // Of {"size": [a, b, c]}: the lengths of edges, none below zero.
  std::array<double, 3> box_size(const Json& value, const std::string& where) const;

  // What space_objects.h says of a ball, a capsule, a cylinder, a cone, an ellipsoid. Requires one of these kinds.
  solid::RoundBody round_body(std::string_view kind, const Json& value, const std::string& where) const;

 private:
  std::string_view file_;
};

}  // namespace sunder::io
