#include <sunder/base/contract.h>
#include <sunder/io/text/json_shapes_internal.h>
#include <sunder/io/text/text.h>

#include <fmt/ranges.h>

#include <algorithm>

namespace sunder::io {

void JsonShapes::fail(const std::string& where, const std::string& what) const {
  fail_file(file_, where + ": " + what);
}

void JsonShapes::require_keys(const Json& value, const std::string& where, Keys known) const {
  const std::string all = fmt::format("{}", fmt::join(known, ", "));
  if (!value.is_object()) fail(where, "is no object with the keys " + all);
  for (const auto& item : value.items()) {
    if (std::find(known.begin(), known.end(), item.key()) == known.end()) {
      fail(where, fmt::format("the key {} is not known; known are {}", quote(item.key()), all));
    }
  }
}

const nlohmann::json& JsonShapes::member(const Json& value, const std::string& where, const std::string& key,
                                         Keys known) const {
  require_keys(value, where, known);
  const auto found = value.find(key);
  if (found == value.end()) fail(where, fmt::format("has no \"{}\"; give it", key));
  return *found;
}

double JsonShapes::number(const Json& value, const std::string& where) const {
  if (!value.is_number()) fail(where, fmt::format("{} is not a number", quote(value.dump())));
  return value.get<double>() + 0.0;
}

Point3 JsonShapes::point(const Json& value, const std::string& where) const {
  const auto [x, y, z] = numbers<3>(value, where, "[x, y, z]");
  return {x, y, z};
}

std::vector<Point3> JsonShapes::points(const Json& value, const std::string& where) const {
  if (!value.is_array()) fail(where, "is no list of points, each [x, y, z]");
  std::vector<Point3> result;
  for (const Json& p : value) result.push_back(point(p, fmt::format("{}[{}]", where, result.size())));
  return result;
}

std::array<double, 3> JsonShapes::box_size(const Json& value, const std::string& where) const {
  const auto size = numbers<3>(member(value, where, "size", {"size"}), where + ".size", "[a, b, c]");
  for (const double edge : size) {
    if (edge < 0) fail(where + ".size", fmt::format("{} is below zero; give the lengths of edges", edge));
  }
  return size;
}

solid::RoundBody JsonShapes::round_body(std::string_view kind, const Json& value, const std::string& where) const {
  using solid::RoundBody;
  const auto inner = [&](const char* key, Keys keys) -> const Json& { return member(value, where, key, keys); };
  const auto at = [&](const char* key, Keys keys) { return point(inner(key, keys), where + "." + key); };
  const auto radius = [&](Keys keys) { return number(inner("radius", keys), where + ".radius"); };
  try {
    if (kind == "ball") {
      const Keys keys{"center", "radius"};
      const Point3 center = at("center", keys);
      return RoundBody::ball(center, radius(keys));
    }
    if (kind == "cone") {
      const Keys keys{"base", "apex", "radius"};
      const Point3 base = at("base", keys), apex = at("apex", keys);
      return RoundBody::cone(base, apex, radius(keys));
    }
    if (kind == "ellipsoid") {
      const Keys keys{"center", "semi_axes"};
      const Point3 center = at("center", keys);
      return RoundBody::ellipsoid(center, numbers<3>(inner("semi_axes", keys), where + ".semi_axes", "[a, b, c]"));
    }
    SUNDER_REQUIRE(kind == "capsule" || kind == "cylinder");
    const Keys keys{"ends", "radius"};
    const Json& list = inner("ends", keys);
    if (!list.is_array() || list.size() != 2) fail(where + ".ends", "is no list of two points, each [x, y, z]");
    const Point3 first = point(list[0], where + ".ends[0]"), second = point(list[1], where + ".ends[1]");
    const double r = radius(keys);
    return kind == "capsule" ? RoundBody::capsule(first, second, r) : RoundBody::cylinder(first, second, r);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::bad_file) throw;
    fail(where, error.what());
  }
}

}  // namespace sunder::io
