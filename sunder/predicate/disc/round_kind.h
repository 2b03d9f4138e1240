// The kinds of bodies with a radius.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunder {

// A core of points, which a pose maps, and a radius, which stays as it is. y is a convex combination of the (placed)
// core, and the body is of all points x such that, for some y:
enum class RoundKind : std::uint8_t {
  hull,  // any number of points: x is within the radius of y. A ball, a capsule, a rounded box; with radius 0 a hull
  cylinder,  // two points, base and top: likewise, and x - y is perpendicular to the axis
  cone,      // two points, base and apex: likewise, within the radius times the weight of the base
  ellipsoid  // one point: x is the image, under the pose, of a point within the radius of the core's
};

// What certificate files call the radius (docs/claims.md, "Tables"), and how many points the core has; 0: any number.
struct RoundKindRow {
  const char* key;
  std::size_t points;
};
inline const RoundKindRow& row_of(RoundKind kind) {
  static constexpr std::array<RoundKindRow, 4> rows{{{"radius", 0}, {"cylinder", 2}, {"cone", 2}, {"ellipsoid", 1}}};
  return rows[static_cast<std::size_t>(kind)];
}

}  // namespace sunder
