// The ends of segments in the order of a sweep.
// Also called: sorted event points of a plane sweep.
#pragma once

#include <sunder/planar/object/segments.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// 2 i is the first end of segment i, 2 i + 1 its last. Ordered lexicographically by their points; at one point first
// the ends that are last, then segments of length zero, each first end followed by its last, then the ends that are
// first; in each of these the lower number first. Cost: O(N log N) comparisons at worst; for many, three passes over
// keys and little more. Requires at most 2^31 - 1.
std::vector<std::uint32_t> ends_in_order(std::span<const Segment> segments);

inline const Point2& end_point(std::span<const Segment> segments, std::uint32_t end) {
  const Segment& s = segments[end / 2];
  return end % 2 == 0 ? s.a : s.b;
}

}  // namespace sunder::planar
