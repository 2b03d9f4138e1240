// Exact numbers of the form m 2^e: the last stage of a predicate. Every finite double is one, and sums, differences
// and products stay so, without overflow or underflow.
// Also called: big floats; arbitrary-precision binary floating point.
#pragma once

#include <sunder/number/interval.h>
#include <sunder/number/sign.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace sunder {

// The mantissa needs no memory of its own up to 768 bits, and may grow beyond.
class Dyadic {
 public:
  Dyadic() noexcept;  // zero
  Dyadic(double x);   // exact; requires a finite x
  Dyadic(const Dyadic& other);
  Dyadic(Dyadic&& other) noexcept;
  Dyadic& operator=(const Dyadic& other);
  Dyadic& operator=(Dyadic&& other) noexcept;
  ~Dyadic();

  static Dyadic power_of_two(std::int64_t exponent);

  std::int64_t exponent() const noexcept { return exponent_; }  // of the form m 2^e; any, where m is zero
  Sign sign() const noexcept;

  // 2^top() <= |x| < 2^(top() + 1). Requires that it is not zero.
  std::int64_t top() const;

  // The number times 2^exponent.
  Dyadic scaled(std::int64_t exponent) const;

  // The interval of neighbouring doubles around the number; outside the range of doubles, towards infinity or zero.
  Interval enclosure() const;

  // The nearest double, ties to even; infinite beyond the range.
  double nearest() const;

  // The form 0xH p E of docs/claims.md, and back to the same number by any reader of that form.
  std::string hexadecimal() const;

  friend Dyadic operator-(const Dyadic& a);
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).sign() == Sign::zero; }

 private:
  friend struct DyadicParts;  // of dyadic.cpp: sees the mantissa

  alignas(16) std::byte mantissa_[112];  // an Integer of integer_internal.h
  std::int64_t exponent_ = 0;
};

inline Guess sign(const Dyadic& x) { return static_cast<Guess>(static_cast<std::int8_t>(x.sign())); }

// The double nearest to numerator / denominator, ties to even; infinite beyond the range. Requires denominator != 0.
double nearest_ratio(const Dyadic& numerator, const Dyadic& denominator);

// The fraction numerator / denominator in lowest terms, as "n/d", or "n" where d is 1. Requires denominator != 0.
std::string fraction_text(const Dyadic& numerator, const Dyadic& denominator);

}  // namespace sunder
