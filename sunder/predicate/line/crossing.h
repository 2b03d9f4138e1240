// The point in which two segments cross, without computing it: predicates decide about the exact point.
// Also called: vertex of an arrangement of segments; intersection point predicates.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/interval.h>
#include <sunder/number/sign.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <algorithm>

namespace sunder {

// The common point of the lines ab and cd, which are not parallel.
struct Crossing {
  Point2 a, b, c, d;
};

ExactPoint2 exact_point(const Crossing& p);
ExactPoint2 exact_crossing(const Vector2<Dyadic>& a, const Vector2<Dyadic>& b,  // of the lines ab and cd
                           const Vector2<Dyadic>& c, const Vector2<Dyadic>& d);

// Hold its coordinates; the whole line where floating point can tell nothing.
struct Enclosure2 {
  Interval x, y;
};
Enclosure2 enclosure(const Crossing& p);
inline Enclosure2 hull(const Enclosure2& p, const Enclosure2& q) {
  return {{std::min(p.x.low, q.x.low), std::max(p.x.high, q.x.high)},
          {std::min(p.y.low, q.y.low), std::max(p.y.high, q.y.high)}};
}

// Lexicographically (by x, then by y): the sign of p - q. `p_in` and `q_in` are enclosures of the points.
// Cost: two comparisons where enclosures are apart; else exact arithmetic.
Sign compare(const Crossing& p, const Enclosure2& p_in, const Crossing& q, const Enclosure2& q_in,
             StageTally* tally = nullptr);
Sign compare(const Crossing& p, const Enclosure2& p_in, const Point2& q, StageTally* tally = nullptr);

// As orient_2d of s, t and p: positive where p is left of the line from s to t.
Sign orient_2d(const Point2& s, const Point2& t, const Crossing& p, const Enclosure2& p_in,
               StageTally* tally = nullptr);

}  // namespace sunder
