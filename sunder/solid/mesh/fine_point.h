// Points with more digits than a double has, where what is between two planes is thin.
// Also called: double-double and quad-double arithmetic; floating-point expansions.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <cstddef>

namespace sunder::solid {

// Each coordinate is the sum of four doubles, all finite, the greater ones first; most are zero.
struct FinePoint {
  std::array<Point3, 4> parts{};
};

inline std::array<Dyadic, 3> exact(const FinePoint& p) {
  std::array<Dyadic, 3> sum;
  for (const Point3& part : p.parts) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (part[c] != 0) sum[c] = sum[c] + Dyadic(part[c]);
    }
  }
  return sum;
}

// The same point, as the image of (1, 1, 1) under the pose, which is overwritten, and has to outlive the result.
inline Posed3 posed_at(const FinePoint& p, Affine3& pose) {
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) pose.linear[3 * r + c] = p.parts[c][r];
    pose.translation[r] = p.parts[3][r];
  }
  return posed({1, 1, 1}, pose);
}

}  // namespace sunder::solid
