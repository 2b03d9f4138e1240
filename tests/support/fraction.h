// Fractions for oracles: exact, and quick where denominators are powers of two, as those of doubles are.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <utility>

namespace sunder::tests {

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

// n 2^e / d with n and d odd, d > 0, or zero. A power of two is cancelled by a shift; what else n and d have in common
// only where they are long.
class Fraction {
 public:
  Fraction() = default;
  Fraction(int x) : n_(x) { cancel(); }
  Fraction(std::int64_t x) : n_(x) { cancel(); }
  Fraction(Integer x) : n_(std::move(x)) { cancel(); }
  Fraction(Integer numerator, Integer denominator) : n_(std::move(numerator)) {
    *this /= Fraction(std::move(denominator));
  }
  Fraction(double x) {
    int e = 0;
    const double m = std::frexp(x, &e);
    n_ = static_cast<std::int64_t>(std::ldexp(m, 53));
    e_ = e - 53;
    cancel();
  }

  // Is it n 2^e?
  bool is_dyadic() const { return n_ % d_ == 0; }
  int sign() const { return n_.sign(); }

  // Of n 2^e: e, or of zero more than any; and what it is in units of 2^unit <= 2^e.
  std::int64_t exponent() const { return n_ == 0 ? std::numeric_limits<std::int64_t>::max() : e_; }
  Integer in_units(std::int64_t unit) const { return n_ == 0 ? n_ : n_ << static_cast<unsigned>(e_ - unit); }

  Fraction scaled(std::int64_t exponent) const {
    Fraction x = *this;
    if (x.n_ != 0) x.e_ += exponent;
    return x;
  }

  // About this number, whose numerator and denominator are in the range of doubles.
  double about() const { return std::ldexp(n_.convert_to<double>() / d_.convert_to<double>(), static_cast<int>(e_)); }

  friend Fraction abs(const Fraction& x) { return x.n_ < 0 ? -x : x; }
  friend Fraction operator-(Fraction x) {
    x.n_ = -x.n_;
    return x;
  }
  Fraction& operator+=(const Fraction& x) {
    if (x.n_ == 0) return *this;
    if (n_ == 0) return *this = x;
    const std::int64_t e = std::min(e_, x.e_);
    Integer of_this = n_ << static_cast<unsigned>(e_ - e), of_x = x.n_ << static_cast<unsigned>(x.e_ - e);
    if (d_ != x.d_) {
      of_this *= x.d_;
      of_x *= d_;
      d_ *= x.d_;
    }
    n_ = of_this + of_x;
    e_ = e;
    cancel();
    return *this;
  }
  Fraction& operator-=(const Fraction& x) { return *this += -x; }
  Fraction& operator*=(const Fraction& x) {
    n_ *= x.n_;
    d_ *= x.d_;
    e_ += x.e_;
    cancel();
    return *this;
  }
  // Requires x != 0.
  Fraction& operator/=(const Fraction& x) {
    n_ *= x.n_ < 0 ? -x.d_ : x.d_;
    d_ *= abs(x.n_);
    e_ -= x.e_;
    cancel();
    return *this;
  }
  friend Fraction operator+(Fraction x, const Fraction& y) { return x += y; }
  friend Fraction operator-(Fraction x, const Fraction& y) { return x -= y; }
  friend Fraction operator*(Fraction x, const Fraction& y) { return x *= y; }
  friend Fraction operator/(Fraction x, const Fraction& y) { return x /= y; }

  friend int compare(const Fraction& x, const Fraction& y) {
    return x.sign() != y.sign() ? (x.sign() < y.sign() ? -1 : 1) : (x - y).sign();
  }
  friend bool operator==(const Fraction& x, const Fraction& y) { return compare(x, y) == 0; }
  friend bool operator<(const Fraction& x, const Fraction& y) { return compare(x, y) < 0; }
  friend bool operator>(const Fraction& x, const Fraction& y) { return compare(x, y) > 0; }
  friend bool operator<=(const Fraction& x, const Fraction& y) { return compare(x, y) <= 0; }
  friend bool operator>=(const Fraction& x, const Fraction& y) { return compare(x, y) >= 0; }
  friend std::ostream& operator<<(std::ostream& out, const Fraction& x) {
    return out << x.n_ << " * 2^" << x.e_ << " / " << x.d_;
  }

 private:
  static constexpr std::int64_t long_bits = 256;

  static std::int64_t bits(const Integer& x) { return static_cast<std::int64_t>(msb(abs(x))) + 1; }

  void cancel() {
    if (n_ == 0) {
      d_ = 1;
      e_ = 0;
      return;
    }
    const auto zeros = lsb(abs(n_));
    if (zeros > 0) {
      const bool is_negative = n_ < 0;  // of the size alone: Boost 1.74 shifts some negative numbers to positive ones
      n_ = abs(n_) >> zeros;
      if (is_negative) n_ = -n_;
      e_ += zeros;
    }
    if (d_ != 1 && bits(d_) > long_bits) divide_by(gcd(n_, d_));
  }
  void divide_by(const Integer& common) {
    if (common == 1) return;
    n_ /= common;
    d_ /= common;
  }

  Integer n_ = 0, d_ = 1;
  std::int64_t e_ = 0;
};

}  // namespace sunder::tests
