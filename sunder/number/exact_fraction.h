// Fractions in exact numbers, and their order.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/interval.h>
#include <sunder/number/sign.h>

#include <compare>
#include <cstdint>
#include <string>
#include <utility>

namespace sunder {

// numerator / denominator, not in lowest terms; the denominator is positive. Two are equal where their values are.
struct ExactFraction {
  Dyadic numerator, denominator{1.0};

  // dividend / divisor. Requires divisor != 0.
  static ExactFraction quotient(Dyadic dividend, Dyadic divisor) {
    if (divisor.sign() == Sign::negative) return {-dividend, -divisor};
    return {std::move(dividend), std::move(divisor)};
  }

  double nearest() const { return nearest_ratio(numerator, denominator); }  // ties to even
  // Neighbouring doubles around it; both are it where it is one.
  Interval enclosure() const;
  std::string text() const { return fraction_text(numerator, denominator); }

  // The sign of x - y.
  friend Sign compare(const ExactFraction& x, const ExactFraction& y) {
    return (x.numerator * y.denominator - y.numerator * x.denominator).sign();
  }
  friend std::weak_ordering operator<=>(const ExactFraction& x, const ExactFraction& y) {
    return static_cast<std::int8_t>(compare(x, y)) <=> 0;
  }
  friend bool operator==(const ExactFraction& x, const ExactFraction& y) { return compare(x, y) == Sign::zero; }
};

// (x + y) / 2
inline ExactFraction middle(const ExactFraction& x, const ExactFraction& y) {
  return {x.numerator * y.denominator + y.numerator * x.denominator, (x.denominator * y.denominator).scaled(1)};
}

}  // namespace sunder
