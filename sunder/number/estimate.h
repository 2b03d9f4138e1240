// Numbers of about 106 bits with a bound of their error: a stage between intervals of doubles and exact numbers, for
// what is wanted to the last bit of a double.
//
//   E1. |exact - value| <= error, for every double, overflow and underflow included (then the bound is infinite, or no
//       number).
// Of a sum the relative error is at most 3 2^-106, of a product a few 2^-106 (double_double.h): 2^-100 of the result
// pays for these and for the roundings of the bound itself, which is a sum of few such numbers, each made larger by
// 2^-100 times more than it loses. What underflows in a product are a few numbers below 2^-1022, each off by 2^-1075 at
// most: 2^-1060 pays for all. An overflow makes a bound that is infinite or no number, and stays.
#pragma once

#include <sunder/number/double_double.h>
#include <sunder/number/sign.h>

#include <cmath>

namespace sunder {

struct Estimate {
  DoubleDouble value;
  double error = 0;

  Estimate() = default;
  Estimate(double x) : value(x) {}  // NOLINT(google-explicit-constructor): exact
  Estimate(const DoubleDouble& v, double e) : value(v), error(e) {}
};

namespace estimate_detail {

// The bound of what was rounded to v: e, which was computed by a few roundings, and what v's own are.
inline double bound(const DoubleDouble& v, double e) { return e * (1 + 0x1p-40) + std::fabs(v.high) * 0x1p-100; }

}  // namespace estimate_detail

inline Estimate operator-(const Estimate& a) { return {-a.value, a.error}; }

inline Estimate operator+(const Estimate& a, const Estimate& b) {
  const DoubleDouble v = a.value + b.value;
  return {v, estimate_detail::bound(v, a.error + b.error)};
}
inline Estimate operator-(const Estimate& a, const Estimate& b) { return a + -b; }

inline Estimate operator*(const Estimate& a, const Estimate& b) {
  const DoubleDouble v = a.value * b.value;
  const double size_a = std::fabs(a.value.high) * (1 + 0x1p-50), size_b = std::fabs(b.value.high) * (1 + 0x1p-50);
  return {v, estimate_detail::bound(v, size_a * b.error + size_b * a.error + a.error * b.error) + 0x1p-1060};
}

inline Guess sign(const Estimate& x) {
  // The high part is the sum rounded: |value| is at least (1 - 2^-52) times its size.
  if (x.value.high * (1 - 0x1p-50) > x.error) return Guess::positive;
  if (x.value.high * (1 - 0x1p-50) < -x.error) return Guess::negative;
  return x.value.high == 0 && x.value.low == 0 && x.error == 0 ? Guess::zero : Guess::unsure;
}

}  // namespace sunder
