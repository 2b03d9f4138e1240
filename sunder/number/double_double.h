// Numbers of about 106 bits as unevaluated sums of two doubles: for searches that double precision is too coarse for.
// Whoever decides with them sees to the range: what is said of exactness and errors holds for results of size 2^-900
// to 2^990, or zero, and factors below 2^990; underflow and overflow are not looked after.
// Sources: Dekker 1971; Knuth 1997, section 4.2.2, theorem B; error bounds: Joldes, Muller, Popescu 2017. Without fused
// multiply-add, so the same everywhere.
// Also called: double-double arithmetic; expansions; compensated arithmetic.
#pragma once

#include <cmath>

namespace sunder {

// high + low, where high is the sum rounded to a double. Whoever gives both keeps to that.
struct DoubleDouble {
  double high = 0, low = 0;

  DoubleDouble() = default;
  DoubleDouble(double x) : high(x) {}  // NOLINT(google-explicit-constructor): every double is one, exactly
  DoubleDouble(double h, double l) : high(h), low(l) {}
};

// a + b, exactly.
inline DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

// a * b, exactly.
inline DoubleDouble exact_product(double a, double b) {
  const auto upper_half = [](double x) {
    const double c = 0x1.0000002p27 * x;  // 2^27 + 1
    return c - (c - x);
  };
  const double product = a * b;
  const double a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

// Relative errors: at most 3 2^-106 of a sum, also where it cancels, and a few 2^-106 of a product or quotient.
inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
  const DoubleDouble sum = exact_sum(high.high, high.low + low.high);
  return exact_sum(sum.high, sum.low + low.low);
}
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = exact_product(a.high, b.high);
  return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * first;
  const double second = rest.high / b.high;
  const double third = (rest - b * second).high / b.high;
  return exact_sum(first, second) + third;
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
inline bool operator>=(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high > b.high || (a.high == b.high && a.low >= b.low);
}
inline bool operator==(const DoubleDouble& a, const DoubleDouble& b) { return a.high == b.high && a.low == b.low; }

inline DoubleDouble& operator+=(DoubleDouble& a, const DoubleDouble& b) { return a = a + b; }
inline DoubleDouble& operator-=(DoubleDouble& a, const DoubleDouble& b) { return a = a - b; }
inline DoubleDouble& operator*=(DoubleDouble& a, const DoubleDouble& b) { return a = a * b; }

inline DoubleDouble magnitude(const DoubleDouble& a) { return a.high < 0 ? -a : a; }
inline double magnitude(double a) { return std::fabs(a); }

// The nearest double.
inline double nearest(const DoubleDouble& a) { return a.high; }
inline double nearest(double a) { return a; }

}  // namespace sunder
