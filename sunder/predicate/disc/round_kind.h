// The kinds of bodies with a radius.
#pragma once

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

}  // namespace sunder
