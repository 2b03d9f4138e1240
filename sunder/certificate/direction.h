// The exact numbers of a certificate's direction.
#pragma once

#include <sunder/certificate/pair.h>
#include <sunder/predicate/point/along.h>

#include <span>

namespace sunder {

// One placed body as certificates see it: its table of vertices and its pose.
struct PlacedVertices {
  std::span<const Point3> vertices;
  const Affine3& pose;
  bool tame;  // as decided by images_are_tame (false is always allowed)

  Posed3 operator[](std::uint32_t v) const { return {vertices[v], &pose, tame}; }
};

// The direction of the world that `direction` names on the bodies A and B. Requires its indices to be in range.
WorldDirection world_direction(const Direction& direction, const PlacedVertices& a, const PlacedVertices& b);

}  // namespace sunder
