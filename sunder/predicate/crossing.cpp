#include <sunder/predicate/crossing.h>

#include <array>

namespace sunder {

namespace {

template <class T>
std::array<T, 2> difference(const Point2& p, const Point2& q) {
  return {T(p.x) - T(q.x), T(p.y) - T(q.y)};
}
template <class T>
T cross(const std::array<T, 2>& u, const std::array<T, 2>& v) {
  return u[0] * v[1] - u[1] * v[0];
}

Sign count(std::uint32_t* counter, Sign sign) {
  if (counter) ++*counter;
  return sign;
}

// Of numbers in these intervals: the sign of the first minus the second, where that is sure.
Guess order(const Interval& a, const Interval& b) {
  if (a.low > b.high) return Guess::positive;
  if (a.high < b.low) return Guess::negative;
  return Guess::unsure;
}

}  // namespace

// p = a + (n / m) (b - a), where n = (c - a) x (d - c) and m = (b - a) x (d - c).
ExactPoint2 exact_point(const Crossing& p) {
  const auto ab = difference<Dyadic>(p.b, p.a), cd = difference<Dyadic>(p.d, p.c), ac = difference<Dyadic>(p.c, p.a);
  Dyadic n = cross(ac, cd), m = cross(ab, cd);
  if (m.sign() == Sign::negative) {
    n = -n;
    m = -m;
  }
  return {Dyadic(p.a.x) * m + n * ab[0], Dyadic(p.a.y) * m + n * ab[1], m};
}

Enclosure2 enclosure(const Crossing& p) {
  const auto ab = difference<Interval>(p.b, p.a), cd = difference<Interval>(p.d, p.c);
  const auto ac = difference<Interval>(p.c, p.a);
  const Interval along = cross(ac, cd) / cross(ab, cd);
  return {Interval(p.a.x) + along * ab[0], Interval(p.a.y) + along * ab[1]};
}

Sign compare(const Crossing& p, const Enclosure2& p_in, const Crossing& q, const Enclosure2& q_in, StageTally* tally) {
  const Guess guess = order(p_in.x, q_in.x);
  if (is_sure(guess)) return count(tally ? &tally->interval : nullptr, to_sign(guess));
  const ExactPoint2 e = exact_point(p), f = exact_point(q);
  const Sign by_x = (e.x * f.denominator - f.x * e.denominator).sign();
  const Sign sign = by_x != Sign::zero ? by_x : (e.y * f.denominator - f.y * e.denominator).sign();
  return count(tally ? &tally->exact : nullptr, sign);
}

Sign compare(const Crossing& p, const Enclosure2& p_in, const Point2& q, StageTally* tally) {
  const Guess guess = order(p_in.x, q.x);
  if (is_sure(guess)) return count(tally ? &tally->interval : nullptr, to_sign(guess));
  const ExactPoint2 e = exact_point(p);
  const Sign by_x = (e.x - Dyadic(q.x) * e.denominator).sign();
  const Sign sign = by_x != Sign::zero ? by_x : (e.y - Dyadic(q.y) * e.denominator).sign();
  return count(tally ? &tally->exact : nullptr, sign);
}

Sign orient_2d(const Point2& s, const Point2& t, const Crossing& p, const Enclosure2& p_in, StageTally* tally) {
  const auto st = difference<Interval>(t, s);
  const Guess guess = sign(st[0] * (p_in.y - s.y) - st[1] * (p_in.x - s.x));
  if (is_sure(guess)) return count(tally ? &tally->interval : nullptr, to_sign(guess));
  const ExactPoint2 e = exact_point(p);
  const auto exact = difference<Dyadic>(t, s);
  const Sign sign =
      (exact[0] * (e.y - Dyadic(s.y) * e.denominator) - exact[1] * (e.x - Dyadic(s.x) * e.denominator)).sign();
  return count(tally ? &tally->exact : nullptr, sign);
}

}  // namespace sunder
