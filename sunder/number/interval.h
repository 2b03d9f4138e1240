// Intervals of doubles in round-to-nearest: the second stage of a predicate.
// Also called: interval arithmetic; dynamic filter.
//
//   I1. The exact result of an operation on any members of the operands lies in the resulting interval,
//       for every double, overflow and underflow included.
// The rounding mode is never changed. A result is widened by at least one unit in the last place on each side:
// for x in [2^e, 2^(e+1)), |x| 2^-52 is between one and two units, and 2^-1074 serves the subnormals. Results known
// to be exact (a factor that is exactly zero) are not widened, so zero stays zero.
#pragma once

#include <sunder/number/sign.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder {

struct Interval {
  double low = 0;
  double high = 0;

  Interval() = default;
  Interval(double x) : low(x), high(x) {}  // exact
  Interval(double l, double h) : low(l), high(h) {}
};

namespace interval_detail {

inline double down(double x) { return x - (std::fabs(x) * 0x1p-52 + 0x1p-1074); }
inline double up(double x) { return x + (std::fabs(x) * 0x1p-52 + 0x1p-1074); }

inline bool is_zero(const Interval& x) { return x.low == 0 && x.high == 0; }

// Widens [l, h] outwards; whatever is not a number becomes the whole line. An infinite bound on the inner side (the
// lower one +infinity, say) would lose what overflowed: it falls back to the largest double.
inline Interval widened(double l, double h) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double largest = std::numeric_limits<double>::max();
  const double low = l == infinity ? largest : down(l);
  const double high = h == -infinity ? -largest : up(h);
  if (!(low <= high)) return {-infinity, infinity};
  return {low, high};
}

}  // namespace interval_detail

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }

// Sums, differences and products are always inlined: else GCC decides by what else is compiled in the same batch, and
// calls cost predicates up to a tenth more instructions (bench_regions, the common part of convex polygons).
[[gnu::always_inline]] inline Interval operator+(const Interval& a, const Interval& b) {
  if (interval_detail::is_zero(a)) return b;
  if (interval_detail::is_zero(b)) return a;
  return interval_detail::widened(a.low + b.low, a.high + b.high);
}

[[gnu::always_inline]] inline Interval operator-(const Interval& a, const Interval& b) { return a + (-b); }

[[gnu::always_inline]] inline Interval operator*(const Interval& a, const Interval& b) {
  if (interval_detail::is_zero(a) || interval_detail::is_zero(b)) return {0.0};
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  if (std::isnan(p + q) || std::isnan(r + s)) {  // 0 * infinity, or two infinities of opposite sign
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {-infinity, infinity};
  }
  return interval_detail::widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}

// Where the divisor holds zero: the whole line.
inline Interval operator/(const Interval& a, const Interval& b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (b.low <= 0 && b.high >= 0) return {-infinity, infinity};
  if (interval_detail::is_zero(a)) return {0.0};
  const double p = a.low / b.low, q = a.low / b.high, r = a.high / b.low, s = a.high / b.high;
  if (std::isnan(p + q) || std::isnan(r + s)) return {-infinity, infinity};
  return interval_detail::widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}

// Of the members that are not negative; there has to be one, exactly, if not in the interval as it is rounded.
inline Interval square_root(const Interval& x) {
  const double low = std::sqrt(std::max(x.low, 0.0)), high = std::sqrt(std::max(x.high, 0.0));
  const Interval wide = interval_detail::widened(low, high);
  return {std::max(wide.low, 0.0), wide.high};
}

inline Guess sign(const Interval& x) {
  if (x.low > 0) return Guess::positive;
  if (x.high < 0) return Guess::negative;
  if (x.low == 0 && x.high == 0) return Guess::zero;
  return Guess::unsure;
}

}  // namespace sunder
