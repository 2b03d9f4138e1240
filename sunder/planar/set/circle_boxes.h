// The boxes of circles as the segments between their corners, so that what finds near segments finds near circles.
#pragma once

#include <sunder/planar/object/circle.h>
#include <sunder/planar/object/segments.h>
#include <sunder/planar/set/contact_rule.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// From the low left to the high right corner, rounded. Rounding keeps order: two discs that meet have boxes that meet,
// rounded as they are. Low ordinates are not above the doubles, high ones not below; both may lie beyond on their side.
inline Segment box_diagonal(const Circle& c) {
  const Point2 p = c.center;
  return {{p.x - c.radius, p.y - c.radius}, {p.x + c.radius, p.y + c.radius}};
}

inline std::vector<Segment> box_diagonals(const Circles& circles) {
  std::vector<Segment> diagonals;
  diagonals.reserve(circles.size());
  for (const Circle& c : circles.all()) diagonals.push_back(box_diagonal(c));
  return diagonals;
}

// Some of the circles as a set of their own, with their groups.
struct CirclesSubset {
  CirclesSubset(const Circles& all, Groups all_groups, std::span<const std::uint32_t> members)
      : circles(chosen(all, members)) {
    if (all_groups.empty()) return;
    for (const std::uint32_t i : members) groups.push_back(all_groups[i]);
  }

  Circles circles;
  std::vector<std::uint32_t> groups;

 private:
  static Circles chosen(const Circles& all, std::span<const std::uint32_t> members) {
    std::vector<Circle> part;
    part.reserve(members.size());
    for (const std::uint32_t i : members) part.push_back(all[i]);
    return Circles(part);
  }
};

}  // namespace sunder::planar
