// The boxes of discs, for what finds near pairs.
#pragma once

#include <sunder/planar/object/discs.h>
#include <sunder/predicate/point.h>

#include <vector>

namespace sunder::planar {

// Rounded, which keeps order: two discs that meet have boxes that meet, rounded as they are. Low ordinates are not
// above the doubles, high ones not below; both may lie beyond on their side.
inline Box2 rounded_box(const Disc& c) {
  const Point2 p = c.center;
  return {{p.x - c.radius, p.y - c.radius}, {p.x + c.radius, p.y + c.radius}};
}

inline std::vector<Box2> rounded_boxes(const Discs& circles) {
  std::vector<Box2> boxes;
  boxes.reserve(circles.size());
  for (const Disc& c : circles.all()) boxes.push_back(rounded_box(c));
  return boxes;
}

}  // namespace sunder::planar
