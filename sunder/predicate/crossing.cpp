#include <sunder/predicate/crossing.h>
#include <sunder/predicate/stages.h>

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

Point2 nearest(const ExactPoint2& p) { return {nearest_ratio(p.x, p.denominator), nearest_ratio(p.y, p.denominator)}; }

Enclosure2 enclosure(const Crossing& p) {
  const auto ab = difference<IntervalStage>(p.b, p.a), cd = difference<IntervalStage>(p.d, p.c);
  const auto ac = difference<IntervalStage>(p.c, p.a);
  const Interval along = cross(ac, cd) / cross(ab, cd);
  return {Interval(p.a.x) + along * ab.x, Interval(p.a.y) + along * ab.y};
}

Sign compare(const Crossing& p, const Enclosure2& p_in, const Crossing& q, const Enclosure2& q_in, StageTally* tally) {
  const Guess guess = order(p_in.x, q_in.x);
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  const ExactPoint2 e = exact_point(p), f = exact_point(q);
  const Sign by_x = (e.x * f.denominator - f.x * e.denominator).sign();
  const Sign sign = by_x != Sign::zero ? by_x : (e.y * f.denominator - f.y * e.denominator).sign();
  return counted(&StageTally::exact, tally, sign);
}

Sign compare(const Crossing& p, const Enclosure2& p_in, const Point2& q, StageTally* tally) {
  const Guess guess = order(p_in.x, q.x);
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  const ExactPoint2 e = exact_point(p);
  const Sign by_x = (e.x - Dyadic(q.x) * e.denominator).sign();
  const Sign sign = by_x != Sign::zero ? by_x : (e.y - Dyadic(q.y) * e.denominator).sign();
  return counted(&StageTally::exact, tally, sign);
}

Sign orient_2d(const Point2& s, const Point2& t, const Crossing& p, const Enclosure2& p_in, StageTally* tally) {
  const Guess guess = sign(cross(difference<IntervalStage>(t, s), Vector2<Interval>{p_in.x - s.x, p_in.y - s.y}));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  const ExactPoint2 e = exact_point(p);
  const Vector2<Dyadic> from_s{e.x - Dyadic(s.x) * e.denominator, e.y - Dyadic(s.y) * e.denominator};
  return counted(&StageTally::exact, tally, cross(difference<ExactStage>(t, s), from_s).sign());
}

}  // namespace sunder
