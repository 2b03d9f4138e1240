// Segments of the plane: closed, of any length, also zero.
#pragma once

#include <sunder/predicate/point.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace sunder::planar {

// In lexicographic order: by x, then by y. (-0 equals 0.)
inline bool lexicographically_less(const Point2& p, const Point2& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

struct Segment {
  Point2 a, b;  // of a member of Segments: a is lexicographically not after b
  friend bool operator==(const Segment&, const Segment&) = default;
};

// From its lexicographically first end to its last.
inline Segment sorted(const Segment& s) { return lexicographically_less(s.b, s.a) ? Segment{s.b, s.a} : s; }

// Of some segments: their common box, and the sums of the widths and heights of their boxes.
struct SegmentExtents {
  Box2 box{{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
           {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}};
  double sum_x = 0, sum_y = 0;  // rounded

  // Requires s.a lexicographically not after s.b.
  void add(const Segment& s) {
    const double bottom = std::min(s.a.y, s.b.y), top = std::max(s.a.y, s.b.y);
    box.low = {std::min(box.low.x, s.a.x), std::min(box.low.y, bottom)};
    box.high = {std::max(box.high.x, s.b.x), std::max(box.high.y, top)};
    sum_x += s.b.x - s.a.x;
    sum_y += top - bottom;
  }
};

// A set of segments, numbered from 0. Immutable; any number of threads may use it.
// P1. All coordinates are finite.
// P2. a of each segment is lexicographically not after b. Which end was given first is not kept.
class Segments {
 public:
  // Throws Error bad_value: "segment 7: ..." where a coordinate is not finite; bad_shape for 2^31 segments or more.
  explicit Segments(std::span<const Segment> given);

  std::uint32_t size() const { return static_cast<std::uint32_t>(segments_.size()); }
  const Segment& operator[](std::uint32_t i) const { return segments_[i]; }
  std::span<const Segment> all() const { return segments_; }
  const SegmentExtents& extents() const { return extents_; }

 private:
  std::vector<Segment> segments_;
  SegmentExtents extents_;
};

}  // namespace sunder::planar
