// Points with more digits than a double has, where what is between two planes is thin.
// Also called: double-double arithmetic.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

namespace sunder::solid {

// Each coordinate is the sum of two doubles, all finite.
struct FinePoint {
  Point3 high, low;
};

// The same point, as the image of (1, 1, 1) under the pose, which is overwritten, and has to outlive the result.
inline Posed3 posed_at(const FinePoint& p, Affine3& pose) {
  pose.linear = {p.high.x, 0, 0, 0, p.high.y, 0, 0, 0, p.high.z};
  pose.translation = {p.low.x, p.low.y, p.low.z};
  return posed({1, 1, 1}, pose);
}

}  // namespace sunder::solid
