#include <sunder/number/double_double.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/line/arrows.h>

#include <cmath>

namespace sunder {

namespace {

constexpr auto cross_formula = [](const auto& p, const auto& q, const auto& r, const auto& s) {
  return cross(q - p, s - r);
};
constexpr auto dot_formula = [](const auto& p, const auto& q, const auto& r, const auto& s) {
  return dot(q - p, s - r);
};

// Is the difference of two doubles a double, and of moderate size? (Overflow makes the answer no.)
bool is_exact(double to, double from, double difference) {
  return exact_sum(to, -from).low == 0 && std::fabs(difference) < 0x1p480;
}

// Products of these neither overflow nor lose bits: zero, or of a size in [2^-400, 2^480].
bool is_moderate(double x) { return x == 0 || std::fabs(x) > 0x1p-400; }

}  // namespace

Guess sign_of_exact_differences(double a1, double a0, double b1, double b0, double c1, double c0, double d1,
                                double d0) {
  const double a = a1 - a0, b = b1 - b0, c = c1 - c0, d = d1 - d0;
  if (!is_exact(a1, a0, a) || !is_exact(b1, b0, b) || !is_exact(c1, c0, c) || !is_exact(d1, d0, d))
    return Guess::unsure;
  if (!is_moderate(a) || !is_moderate(b) || !is_moderate(c) || !is_moderate(d)) return Guess::unsure;
  // Rounding keeps order: where the rounded products differ, so do the exact ones, in the same way.
  const DoubleDouble left = exact_product(a, b), right = exact_product(c, d);
  const double more = left.high != -right.high ? left.high : left.low;
  const double less = left.high != -right.high ? -right.high : -right.low;
  return more > less ? Guess::positive : more < less ? Guess::negative : Guess::zero;
}

Sign cross_2d_further(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally) {
  const Guess guess = sign_of_exact_differences(q.x, p.x, s.y, r.y, p.y, q.y, s.x, r.x);
  if (!is_sure(guess)) return decide(tally, cross_formula, p, q, r, s);
  return counted(&StageTally::exact, tally, to_sign(guess));
}
Sign cross_2d_further(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally) {
  return decide(tally, cross_formula, p, q, r, s);
}
Sign dot_2d_further(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally) {
  const Guess guess = sign_of_exact_differences(q.x, p.x, s.x, r.x, q.y, p.y, s.y, r.y);
  if (!is_sure(guess)) return decide(tally, dot_formula, p, q, r, s);
  return counted(&StageTally::exact, tally, to_sign(guess));
}
Sign dot_2d_further(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally) {
  return decide(tally, dot_formula, p, q, r, s);
}

}  // namespace sunder
