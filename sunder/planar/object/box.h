// A closed box of the plane, its sides along the axes.
#pragma once

#include <algorithm>

namespace sunder::planar {

struct Box {
  double left = 0, right = 0, bottom = 0, top = 0;  // finite; left <= right, bottom <= top
  friend bool operator==(const Box&, const Box&) = default;
};

inline bool meet(const Box& a, const Box& b) {
  return a.left <= b.right && b.left <= a.right && a.bottom <= b.top && b.bottom <= a.top;
}

inline bool holds(const Box& outer, const Box& inner) {
  return outer.left <= inner.left && inner.right <= outer.right && outer.bottom <= inner.bottom &&
         inner.top <= outer.top;
}

// The smallest box that holds both.
inline Box hull(const Box& a, const Box& b) {
  return {std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.bottom, b.bottom), std::max(a.top, b.top)};
}

// What two boxes have in common. Requires that they meet.
inline Box common_part(const Box& a, const Box& b) {
  return {std::max(a.left, b.left), std::min(a.right, b.right), std::max(a.bottom, b.bottom), std::min(a.top, b.top)};
}

}  // namespace sunder::planar
