// Segments of the plane: closed, of any length, also zero.
// Also called: line segments; edges.
#pragma once

#include <sunder/base/error.h>
#include <sunder/near/box_grid.h>
#include <sunder/near/lanes_box.h>

#include <algorithm>
#include <cstdint>
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

// Of two on one line that meet, each with its first end first: what they have in common, exactly. Where they do not
// meet, its ends are the other way round. (On one line, the lexicographic order is the order along it.)
inline Segment common_part(const Segment& s, const Segment& t) {
  return {lexicographically_less(s.a, t.a) ? t.a : s.a, lexicographically_less(s.b, t.b) ? s.b : t.b};
}

// The box between its ends, which is its box. Requires s.a.x <= s.b.x.
inline Box2 box_of(const Segment& s) { return {{s.a.x, std::min(s.a.y, s.b.y)}, {s.b.x, std::max(s.a.y, s.b.y)}}; }
inline LanesBox lanes_box_of(const Segment& s) { return lanes_box_of(s.a, s.b); }  // in any order

// A set of segments, numbered from 0. Immutable; any number of threads may use it.
// P1. All coordinates are finite.
// P2. a of each segment is lexicographically not after b. Which end was given first is not kept.
class Segments {
 public:
  // Throws Error bad_value: "segment 7: ..." where a coordinate is not finite; bad_shape for 2^31 segments or more.
  explicit Segments(std::vector<Segment> given);

  std::uint32_t size() const { return static_cast<std::uint32_t>(segments_.size()); }
  const Segment& operator[](std::uint32_t i) const { return segments_[i]; }
  std::span<const Segment> all() const { return segments_; }
  const BoxExtents& extents() const { return extents_; }

 private:
  std::vector<Segment> segments_;
  BoxExtents extents_;
};

}  // namespace sunder::planar
