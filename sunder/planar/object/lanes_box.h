// A closed box of the plane in vector registers, to be compared without branches.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/predicate/point.h>

namespace sunder::planar {

// A box: its low and its high corner, of which both coordinates are compared at once.
struct LanesBox {
  Lanes low, high;

  static LanesBox of(const Box2& b) { return {Lanes{b.low.x, b.low.y}, Lanes{b.high.x, b.high.y}}; }
};

inline bool meet(const LanesBox& a, const LanesBox& b) {
  return (bits_of(a.low > b.high) | bits_of(a.high < b.low)) == 0;
}

inline LanesBox box_of_edge(const Point2& from, const Point2& to) {
  const Lanes a = lanes_at(&from.x), b = lanes_at(&to.x);
  return {smaller_of(a, b), greater_of(a, b)};
}

inline LanesBox hull(const LanesBox& a, const LanesBox& b) {
  return {smaller_of(a.low, b.low), greater_of(a.high, b.high)};
}

}  // namespace sunder::planar
