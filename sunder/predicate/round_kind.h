// What kinds of bodies with a radius there are: points, their convex hull, and what the radius makes of it.
#pragma once

#include <cstdint>

namespace sunder {

enum class RoundKind : std::uint8_t {
  hull,       // all within the radius of the hull of the points: a ball, a capsule, a rounded polyhedron; of radius 0
              // the polyhedron itself
  cylinder,   // all within the radius of the segment from base to top, measured across it
  cone,       // the same, where the radius shrinks from the base to zero at the apex
  ellipsoid,  // the image of a ball
};

}  // namespace sunder
