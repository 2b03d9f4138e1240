// A closed box of the plane in vector registers, to be compared without branches.
// Also called: axis-aligned bounding box (AABB).
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/predicate/point.h>

namespace sunder {

// A box: its low and its high corner, of which both coordinates are compared at once.
struct LanesBox {
  Lanes low, high;
};

inline LanesBox lanes_box_of(const Box2& b) { return {lanes_at(&b.low.x), lanes_at(&b.high.x)}; }

// The box of two points.
inline LanesBox lanes_box_of(const Point2& p, const Point2& q) {
  const Lanes a = lanes_at(&p.x), b = lanes_at(&q.x);
  return {smaller_of(a, b), greater_of(a, b)};
}

inline bool meet(const LanesBox& a, const LanesBox& b) {
  return (bits_of(a.low > b.high) | bits_of(a.high < b.low)) == 0;
}

inline LanesBox hull(const LanesBox& a, const LanesBox& b) {
  return {smaller_of(a.low, b.low), greater_of(a.high, b.high)};
}

}  // namespace sunder
