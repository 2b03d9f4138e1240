// A linear map that makes a body round: about as long in every direction. For searches; nothing here decides anything.
// Also called: whitening; isotropic position; an approximate Loewner-John frame.
//
// A plate or a needle along no axis is flat in every frame that only stretches axes. Signs of its polar do not depend
// on a linear map, and what two nearly parallel facets nearly cancel in, stands out where the body is round.
//
// Of four vertices a, b, c, d, each furthest from the flat of those before it: the axes of the frame are the direction
// from a to b, what is perpendicular to it towards c, and the normal of the three, and along each the last vertex has
// the coordinate 1. So all of the body has coordinates between -1 and 1 about a.
#pragma once

#include <sunder/number/vector.h>
#include <sunder/predicate/point.h>

#include <array>
#include <span>

namespace sunder::solid {

struct RoundFrame {
  std::array<Point3, 3> row{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}};  // of positive determinant
  bool is_identity = true;

  // Of a difference of points; in the numbers that it has.
  template <class V>
  V operator()(const V& x) const {
    if (is_identity) return x;
    const auto along = [&](const Point3& r) { return x.x * r.x + x.y * r.y + x.z * r.z; };
    return {along(row[0]), along(row[1]), along(row[2])};
  }
};

// Of a body with an interior. The identity where the body is round already, to a factor of 256, or too flat for doubles
// to tell (2^-200). Cost: O(n).
RoundFrame make_round_frame(std::span<const Point3> vertices);

}  // namespace sunder::solid
