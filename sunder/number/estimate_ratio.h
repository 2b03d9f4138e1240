// The quotient of two estimates (estimate.h), and the double that it rounds to, where that is sure.
#pragma once

#include <sunder/number/estimate.h>

#include <cmath>
#include <limits>
#include <optional>

namespace sunder {

// The double that a number rounds to, if all that are as near as the error says round to it.
inline std::optional<double> surely_nearest(const DoubleDouble& value, double error) {
  const double e = error * (1 + 0x1p-50) + std::fabs(value.low) * 0x1p-50;
  const double nearest = value.high;
  if (nearest + (value.low + e) == nearest && nearest + (value.low - e) == nearest) return nearest;
  return {};
}

// What is left of the numerator after this quotient bounds the error of it. Infinite, or no number, where the
// denominator may be zero.
inline Estimate ratio(const Estimate& numerator, const Estimate& denominator) {
  const DoubleDouble quotient = numerator.value / denominator.value;
  const Estimate rest = numerator - Estimate(quotient, 0) * denominator;
  const double least = std::fabs(denominator.value.high) * (1 - 0x1p-50) - denominator.error;
  if (!(least > 0)) return {quotient, std::numeric_limits<double>::infinity()};
  return {quotient, (std::fabs(rest.value.high) * (1 + 0x1p-50) + rest.error) / least * (1 + 0x1p-50)};
}

}  // namespace sunder
