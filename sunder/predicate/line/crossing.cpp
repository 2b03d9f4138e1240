#include <sunder/predicate/filter/sharp_stage.h>
#include <sunder/predicate/line/crossing.h>

#include <algorithm>
#include <cmath>

namespace sunder {

namespace {

template <class Stage>
auto difference(const Point2& p, const Point2& q) {
  return lift<Stage>(p) - lift<Stage>(q);
}

// Of numbers in these intervals: the sign of the first minus the second, where that is sure.
Guess order(const Interval& a, const Interval& b) {
  if (a.low > b.high) return Guess::positive;
  if (a.high < b.low) return Guess::negative;
  return Guess::unsure;
}

// The crossing is at a + (n / m) (b - a), as exact_crossing has it.
struct SharpCrossing {
  Sharp n, m;
  Vector2<Sharp> ab;
};
SharpCrossing sharply(const Crossing& p) {
  const auto cd = difference<SharpStage>(p.d, p.c), ab = difference<SharpStage>(p.b, p.a);
  return {cross(difference<SharpStage>(p.c, p.a), cd), cross(ab, cd), ab};
}

// The sign of the first, where that of the others, which it was multiplied by, is taken out of it.
Guess divided(const Sharp& x, const Sharp& by) {
  const Guess a = sign(x), b = sign(by);
  if (a == Guess::unsure || b == Guess::unsure) return Guess::unsure;
  return a == b ? Guess::positive : Guess::negative;
}

// Of the abscissas: that of p less that of q.
Guess sharp_order(const Crossing& p, const Crossing& q) {
  const SharpCrossing e = sharply(p), f = sharply(q);
  const Sharp apart = difference<SharpStage>(p.a, q.a).x, m = e.m * f.m;
  return divided(apart * m + (e.n * e.ab.x * f.m - f.n * f.ab.x * e.m), m);
}
Guess sharp_order(const Crossing& p, const Point2& q) {
  const SharpCrossing e = sharply(p);
  return divided(difference<SharpStage>(p.a, q).x * e.m + e.n * e.ab.x, e.m);
}

// As a quotient of intervals that is narrower than 2^-30 of its divisor, or by double-doubles.
Interval along(const Crossing& p) {
  const auto ab = difference<IntervalStage>(p.b, p.a), cd = difference<IntervalStage>(p.d, p.c);
  const Interval m = cross(ab, cd), n = cross(difference<IntervalStage>(p.c, p.a), cd);
  const double least = std::min(std::fabs(m.low), std::fabs(m.high));
  if ((m.low < 0) == (m.high < 0) && m.high - m.low < 0x1p-30 * least && n.high - n.low < 0x1p-30 * least) return n / m;
  const SharpCrossing e = sharply(p);
  if (!is_sure(sign(e.m))) return n / m;
  const auto around = [](const Sharp& x) {
    const double error = 2 * x.error;
    return Interval(x.value.high) + Interval(x.value.low - error, x.value.low + error);
  };
  return around(e.n) / around(e.m);
}

}  // namespace

// a + (n / m) (b - a), where n = (c - a) x (d - c) and m = (b - a) x (d - c).
ExactPoint2 exact_crossing(const Vector2<Dyadic>& a, const Vector2<Dyadic>& b, const Vector2<Dyadic>& c,
                           const Vector2<Dyadic>& d) {
  const Vector2<Dyadic> ab = b - a, cd = d - c;
  Dyadic n = cross(c - a, cd), m = cross(ab, cd);
  if (m.sign() == Sign::negative) {
    n = -n;
    m = -m;
  }
  return {a.x * m + n * ab.x, a.y * m + n * ab.y, m};
}

ExactPoint2 exact_point(const Crossing& p) {
  return exact_crossing(lift<ExactStage>(p.a), lift<ExactStage>(p.b), lift<ExactStage>(p.c), lift<ExactStage>(p.d));
}

Enclosure2 enclosure(const Crossing& p) {
  const auto ab = difference<IntervalStage>(p.b, p.a);
  const Interval part = along(p);
  return {Interval(p.a.x) + part * ab.x, Interval(p.a.y) + part * ab.y};
}

Sign compare(const Crossing& p, const Enclosure2& p_in, const Crossing& q, const Enclosure2& q_in, StageTally* tally) {
  Guess guess = order(p_in.x, q_in.x);
  if (!is_sure(guess)) guess = sharp_order(p, q);
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  const ExactPoint2 e = exact_point(p), f = exact_point(q);
  const Sign by_x = (e.x * f.denominator - f.x * e.denominator).sign();
  const Sign sign = by_x != Sign::zero ? by_x : (e.y * f.denominator - f.y * e.denominator).sign();
  return counted(&StageTally::exact, tally, sign);
}

Sign compare(const Crossing& p, const Enclosure2& p_in, const Point2& q, StageTally* tally) {
  Guess guess = order(p_in.x, q.x);
  if (!is_sure(guess)) guess = sharp_order(p, q);
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  const ExactPoint2 e = exact_point(p);
  const Sign by_x = (e.x - Dyadic(q.x) * e.denominator).sign();
  const Sign sign = by_x != Sign::zero ? by_x : (e.y - Dyadic(q.y) * e.denominator).sign();
  return counted(&StageTally::exact, tally, sign);
}

Sign orient_2d(const Point2& s, const Point2& t, const Crossing& p, const Enclosure2& p_in, StageTally* tally) {
  Guess guess = sign(cross(difference<IntervalStage>(t, s), Vector2<Interval>{p_in.x - s.x, p_in.y - s.y}));
  if (!is_sure(guess)) {
    const SharpCrossing e = sharply(p);
    const auto st = difference<SharpStage>(t, s), from_s = difference<SharpStage>(p.a, s);
    guess = divided(cross(st, from_s) * e.m + cross(st, e.ab) * e.n, e.m);
  }
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  const ExactPoint2 e = exact_point(p);
  const Vector2<Dyadic> from_s{e.x - Dyadic(s.x) * e.denominator, e.y - Dyadic(s.y) * e.denominator};
  return counted(&StageTally::exact, tally, cross(difference<ExactStage>(t, s), from_s).sign());
}

}  // namespace sunder
