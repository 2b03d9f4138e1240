// The square root of a fraction, between neighbouring doubles.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/estimate.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/number/interval.h>

#include <optional>

namespace sunder {

// sqrt(square): both ends are that double where it is one, else they are neighbours around it. Beyond the range of
// doubles: the largest and infinity, zero and the least one. Requires square >= 0.
Interval root(const ExactFraction& square);

// The sign of sqrt(square) - x. Requires square >= 0 and x >= 0.
inline Sign compare_root(const ExactFraction& square, const Dyadic& x) {
  return (square.numerator - x * x * square.denominator).sign();
}

// sqrt(numerator / denominator) of estimates, where they are sure. Never of a root that is a double.
std::optional<Interval> sure_root(const Estimate& numerator, const Estimate& denominator);

}  // namespace sunder
