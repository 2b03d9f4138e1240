#include <sunder/number/double_double.h>
#include <sunder/predicate/disc/discs.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/line/arrows.h>

#include <cmath>

namespace sunder {

namespace {

// Of two discs as (x, y, radius), the second radius with the sign that it has in the sum.
constexpr auto distance_formula = [](const auto& p, const auto& q) {
  const auto x = q.x - p.x;
  const auto y = q.y - p.y;
  const auto reach = p.z + q.z;
  return (x * x + y * y) - reach * reach;
};

// Where doubles hold the differences and the sum, as for numbers of like size: (x - reach) (x + reach) + y y.
Guess sign_by_exact_differences(const Point2& p, double r, const Point2& q, double s) {
  const DoubleDouble x = exact_sum(q.x, -p.x), y = exact_sum(q.y, -p.y), reach = exact_sum(r, s);
  if (x.low != 0 || y.low != 0 || reach.low != 0) return Guess::unsure;  // after overflow: not a number
  return sign_of_exact_differences(x.high, reach.high, x.high, -reach.high, y.high, 0, y.high, 0);
}

}  // namespace

Sign distance_against_further(const Point2& p, double r, const Point2& q, double s, StageTally* tally) {
  const Guess guess = sign_by_exact_differences(p, r, q, s);
  if (!is_sure(guess)) return decide(tally, distance_formula, Point3{p.x, p.y, r}, Point3{q.x, q.y, s});
  return counted(&StageTally::exact, tally, to_sign(guess));
}

Sign compare_sums_further(double a, double b, double c, double d, StageTally* tally) {
  if (tally) ++tally->exact;
  constexpr double large = 0x1p1000;  // below, no step of exact_sum overflows
  const auto is_large = [](double x) { return std::fabs(x) > large; };
  if (is_large(a) || is_large(b) || is_large(c) || is_large(d)) {
    return ((Dyadic(a) + Dyadic(b)) - (Dyadic(c) + Dyadic(d))).sign();
  }
  const DoubleDouble left = exact_sum(a, b), right = exact_sum(c, d);
  return left > right ? Sign::positive : right > left ? Sign::negative : Sign::zero;
}

}  // namespace sunder
