// A stage between intervals and exact numbers, for formulas of differences of coordinates that cancel: double-doubles
// with a bound of their error. For use inside predicate/ and its tests.
// Also called: adaptive arithmetic; floating-point expansions of two components.
#pragma once

#include <sunder/number/double_double.h>
#include <sunder/predicate/filter/stages.h>

#include <cmath>

namespace sunder {

// A number within `error` of `value`. Each operation adds what its own result is rounded by (double_double.h: 3 2^-106
// of a sum, also where it cancels, a few 2^-106 of a product, and 2^-1060 where parts of it underflow) to what its
// operands bring along. Differences of two doubles have no error: double-doubles hold them. Overflow makes the error
// infinite, or no number.
struct Sharp {
  DoubleDouble value;
  double error = 0;
};

// A double as it was given.
struct SharpLeaf {
  double value;
};

inline Sharp operator-(SharpLeaf a, SharpLeaf b) { return {exact_sum(a.value, -b.value), 0}; }
inline Sharp operator+(const Sharp& a, const Sharp& b) {
  const DoubleDouble sum = a.value + b.value;
  return {sum, a.error + b.error + 0x1p-104 * std::fabs(sum.high)};
}
inline Sharp operator-(const Sharp& a, const Sharp& b) { return a + Sharp{-b.value, b.error}; }
inline Sharp operator*(const Sharp& a, const Sharp& b) {
  const DoubleDouble product = a.value * b.value;
  const double size_a = std::fabs(a.value.high), size_b = std::fabs(b.value.high);
  return {product,
          (a.error * (size_b + b.error) + b.error * size_a) + (0x1p-102 * std::fabs(product.high) + 0x1p-1060)};
}

// The factor of two is for the rounding of the error, and of the value to its first double.
inline Guess sign(const Sharp& x) {
  if (x.value.high > 2 * x.error) return Guess::positive;
  if (x.value.high < -2 * x.error) return Guess::negative;
  return Guess::unsure;
}

struct SharpStage {
  static SharpLeaf read(double x) { return {x}; }
};

// For images of points under poses, too, which are sums of products.
struct SharpImageStage {
  static Sharp read(double x) { return {{x, 0}, 0}; }
};

// As decide(), with one of these stages before exact numbers. With SharpStage the formula begins with differences.
template <class Stage = SharpStage, class Formula, class... Points>
Sign decide_sharply(StageTally* tally, const Formula& formula, const Points&... points) {
  if ((is_tame(points) && ...)) {
    const Guess guess = sign(formula(lift<RoundedStage>(points)...));
    if (is_sure(guess)) return counted(&StageTally::rounded, tally, to_sign(guess));
  }
  Guess guess = sign(formula(lift<IntervalStage>(points)...));
  if (!is_sure(guess)) guess = sign(formula(lift<Stage>(points)...));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, formula(lift<ExactStage>(points)...).sign());
}

}  // namespace sunder
