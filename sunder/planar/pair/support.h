// Which vertex of a convex polygon, or of the difference of two, is furthest along a direction? In doubles, for
// searches that propose: extreme_vertex.h decides.
// Also called: support mapping, support function, support point; of the Minkowski difference, too.
#pragma once

#include <sunder/planar/pair/edge_runs.h>
#include <sunder/planar/pair/in_doubles.h>

namespace sunder::planar {

namespace support {

using in_doubles::cross;
using in_doubles::dot;
using in_doubles::operator-;
using in_doubles::scaled;

// The arrow from p to q.
inline Point2 arrow(const Point2& p, const Point2& q) { return q - p; }
inline Point2 arrow(const Posed2& p, const Posed2& q) {
  const auto& m = p.pose->linear;
  const Point2 v = q.point - p.point;
  return {m[0] * v.x + m[1] * v.y, m[2] * v.x + m[3] * v.y};
}

// The polygon's vertex that is furthest along a direction: log2 n + O(1) probes.
template <class Sequence>
class Support {
 public:
  Support(const Sequence& sequence, double scale, Cost& cost) : sequence_(sequence), scale_(scale), cost_(cost) {
    const auto [below, above] = sequence.up();
    up_ = arrow(below, above);
  }

  Point2 vertex(std::uint32_t k) const { return scaled(sequence_.rounded(k), scale_); }

  // Where the edges begin that descend, seen along d; these are to the left of d turned left: see edge_runs.h. Where
  // rounding takes the wrong half, the extreme vertex is at an end of it.
  std::uint32_t furthest_along(const Point2& d) const {
    const std::uint32_t n = sequence_.size();
    const double down = -dot(d, up_), upward = down != 0 ? down : cross(d, up_);
    const std::uint32_t first = upward > 0 ? sequence_.first() : sequence_.second();
    std::uint32_t second = upward > 0 ? sequence_.second() : sequence_.first();
    if (second < first) second += n;
    const std::uint32_t k = first_where(first, second, [&](std::uint32_t e) {
      ++cost_.probes;
      return dot(d, vertex(position(sequence_, position(sequence_, e) + 1)) - vertex(position(sequence_, e))) < 0;
    });
    return position(sequence_, k);
  }

 private:
  const Sequence& sequence_;
  double scale_;
  Cost& cost_;
  Point2 up_;
};

}  // namespace support

// A vertex of A - B: that of a at position i, less that of b at position j.
struct Difference {
  std::uint32_t i = 0, j = 0;
  Point2 p{};  // scaled
};

// Support vertices of A - B. The polygons are scaled to coordinates near 1.
template <class A, class B>
class SupportOfDifference {
 public:
  SupportOfDifference(const A& a, const B& b, Cost& cost)
      : scale_(scale_near_one({a.rounded(0), a.rounded(a.size() / 2), b.rounded(0), b.rounded(b.size() / 2)})),
        a_(a, scale_, cost),
        b_(b, scale_, cost),
        cost_(cost) {}

  Difference vertex(std::uint32_t i, std::uint32_t j) const {
    using in_doubles::operator-;
    cost_.probes += 2;
    return {i, j, a_.vertex(i) - b_.vertex(j)};
  }
  // Cost: log2 n + log2 m + O(1) probes.
  Difference furthest_along(const Point2& d) const {
    return vertex(a_.furthest_along(d), b_.furthest_along({-d.x, -d.y}));
  }

 private:
  double scale_;
  support::Support<A> a_;
  support::Support<B> b_;
  Cost& cost_;
};

}  // namespace sunder::planar
