// Exact numbers of the form m 2^e: the last stage of a predicate. Every finite double is one, and sums, differences
// and products stay so, without overflow or underflow.
#pragma once

#include <sunder/number/interval.h>
#include <sunder/number/sign.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cstdint>
#include <string>

namespace sunder {

// Integers that need no memory of their own up to 768 bits, and may grow beyond.
using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
                                      768, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked,
                                      std::allocator<boost::multiprecision::limb_type>>,
                                  boost::multiprecision::et_off>;

class Dyadic {
 public:
  Dyadic() = default;  // zero
  Dyadic(double x);    // exact; requires a finite x
  Dyadic(Integer mantissa, std::int64_t exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  const Integer& mantissa() const { return mantissa_; }
  std::int64_t exponent() const { return exponent_; }

  Sign sign() const;

  // The interval of neighbouring doubles around the number; outside the range of doubles, towards infinity or zero.
  Interval enclosure() const;

  // The nearest double, ties to even; infinite beyond the range.
  double nearest() const;

  // The form 0xH p E of docs/certificates.md, and back to the same number by any reader of that form.
  std::string hexadecimal() const;

  friend Dyadic operator-(const Dyadic& a) { return {-a.mantissa_, a.exponent_}; }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).sign() == Sign::zero; }

 private:
  Integer mantissa_;
  std::int64_t exponent_ = 0;
};

inline Guess sign(const Dyadic& x) { return static_cast<Guess>(static_cast<std::int8_t>(x.sign())); }

// The double nearest to numerator / denominator, ties to even; infinite beyond the range. Requires denominator != 0.
double nearest_ratio(const Dyadic& numerator, const Dyadic& denominator);

// The fraction numerator / denominator in lowest terms, as "n/d", or "n" where d is 1. Requires denominator != 0.
std::string fraction_text(const Dyadic& numerator, const Dyadic& denominator);

}  // namespace sunder
