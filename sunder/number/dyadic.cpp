#include <sunder/base/contract.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/integer_internal.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace sunder {

struct DyadicParts {
  static_assert(sizeof(Integer) <= sizeof(Dyadic::mantissa_) && alignof(Integer) <= 16);

  static Integer& mantissa(Dyadic& x) { return *std::launder(reinterpret_cast<Integer*>(x.mantissa_)); }
  static const Integer& mantissa(const Dyadic& x) {
    return *std::launder(reinterpret_cast<const Integer*>(x.mantissa_));
  }
  static std::int64_t& exponent(Dyadic& x) { return x.exponent_; }
};

namespace {

// The number of bits of |x|, x not zero.
std::int64_t bit_length(const Integer& x) {
  return static_cast<std::int64_t>(boost::multiprecision::msb(boost::multiprecision::abs(x))) + 1;
}

// |m| 2^e cut to 53 bits (fewer where the result is subnormal): m' 2^e', and what was cut off.
struct Cut {
  std::uint64_t mantissa;  // below 2^53
  std::int64_t exponent;
  bool exact;  // nothing was cut
  int rest;    // the rest against half a unit: -1 below, 0 equal, 1 above
};

Cut cut_to_double(const Integer& mantissa, std::int64_t exponent) {
  const Integer size = boost::multiprecision::abs(mantissa);
  std::int64_t drop = bit_length(size) - 53;
  drop = std::max(drop, -1074 - exponent);  // the last bit of a double weighs at least 2^-1074
  if (drop <= 0) return {static_cast<std::uint64_t>(size), exponent, true, -1};
  const Integer kept = size >> static_cast<unsigned long>(drop);
  const Integer rest = size - (kept << static_cast<unsigned long>(drop));
  const Integer half = Integer(1) << static_cast<unsigned long>(drop - 1);
  return {static_cast<std::uint64_t>(kept), exponent + drop, rest == 0, rest.compare(half)};
}

double double_of(std::uint64_t mantissa, std::int64_t exponent) {
  if (mantissa == 0) return 0;
  const std::int64_t top = exponent + 64;  // enough to tell an overflow, whatever the exponent's size
  return std::ldexp(static_cast<double>(mantissa), static_cast<int>(std::clamp<std::int64_t>(top, -3000, 3000) - 64));
}

}  // namespace

const Integer& mantissa_of(const Dyadic& x) noexcept { return DyadicParts::mantissa(x); }

Dyadic dyadic_of(Integer mantissa, std::int64_t exponent) {
  Dyadic x;
  DyadicParts::mantissa(x) = std::move(mantissa);
  DyadicParts::exponent(x) = exponent;
  return x;
}

Dyadic::Dyadic() noexcept { new (mantissa_) Integer; }

Dyadic::Dyadic(const Dyadic& other) : exponent_(other.exponent_) { new (mantissa_) Integer(mantissa_of(other)); }

Dyadic::Dyadic(Dyadic&& other) noexcept : exponent_(other.exponent_) {
  new (mantissa_) Integer(std::move(DyadicParts::mantissa(other)));
}

Dyadic& Dyadic::operator=(const Dyadic& other) {
  if (this == &other) return *this;
  DyadicParts::mantissa(*this) = mantissa_of(other);
  exponent_ = other.exponent_;
  return *this;
}

Dyadic& Dyadic::operator=(Dyadic&& other) noexcept {
  if (this == &other) return *this;
  DyadicParts::mantissa(*this) = std::move(DyadicParts::mantissa(other));
  exponent_ = other.exponent_;
  return *this;
}

Dyadic::~Dyadic() { DyadicParts::mantissa(*this).~Integer(); }

Dyadic::Dyadic(double x) : Dyadic() {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::int64_t field = static_cast<std::int64_t>(bits >> 52 & 0x7ff);
  if (field != 0) fraction |= std::uint64_t{1} << 52;
  if (fraction == 0) return;
  const int zeros = std::countr_zero(fraction);
  Integer& mantissa = DyadicParts::mantissa(*this);
  mantissa = fraction >> zeros;
  if (bits >> 63) mantissa.backend().negate();
  exponent_ = std::max<std::int64_t>(field, 1) - 1075 + zeros;
}

Dyadic Dyadic::power_of_two(std::int64_t exponent) { return Dyadic(1.0).scaled(exponent); }

Sign Dyadic::sign() const noexcept { return static_cast<Sign>(mantissa_of(*this).sign()); }

std::int64_t Dyadic::top() const {
  SUNDER_REQUIRE(sign() != Sign::zero);
  return bit_length(mantissa_of(*this)) - 1 + exponent_;
}

Dyadic Dyadic::scaled(std::int64_t exponent) const {
  Dyadic x = *this;
  x.exponent_ += exponent;
  return x;
}

Interval Dyadic::enclosure() const {
  const Integer& mantissa = mantissa_of(*this);
  if (mantissa == 0) return {0.0};
  const Cut cut = cut_to_double(mantissa, exponent_);
  const double low = double_of(cut.mantissa, cut.exponent);
  const double high = cut.exact ? low : double_of(cut.mantissa + 1, cut.exponent);
  const double inner = std::isinf(low) ? std::numeric_limits<double>::max() : low;
  return mantissa > 0 ? Interval{inner, high} : Interval{-high, -inner};
}

double Dyadic::nearest() const {
  const Integer& mantissa = mantissa_of(*this);
  if (mantissa == 0) return 0;
  const Cut cut = cut_to_double(mantissa, exponent_);
  const bool up = !cut.exact && (cut.rest > 0 || (cut.rest == 0 && cut.mantissa % 2 == 1));
  const double size = double_of(cut.mantissa + (up ? 1 : 0), cut.exponent);
  return mantissa > 0 ? size : -size;
}

std::string Dyadic::hexadecimal() const {
  const Integer& mantissa = mantissa_of(*this);
  if (mantissa == 0) return "0x0p+0";
  Integer size = boost::multiprecision::abs(mantissa);
  std::int64_t exponent = exponent_;
  const auto zeros = boost::multiprecision::lsb(size);
  size >>= zeros;
  exponent += static_cast<std::int64_t>(zeros);
  std::string text = mantissa < 0 ? "-0x" : "0x";
  text += size.str(0, std::ios_base::hex);
  text += exponent < 0 ? "p-" : "p+";
  return text + std::to_string(std::abs(exponent));
}

// Each is made in place: a number is larger than many of the numbers that it is made of.
Dyadic operator-(const Dyadic& a) {
  Dyadic negated = a;
  DyadicParts::mantissa(negated).backend().negate();
  return negated;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (mantissa_of(a).is_zero()) return b;
  if (mantissa_of(b).is_zero()) return a;
  const bool a_higher = a.exponent() > b.exponent();
  const Dyadic& low = a_higher ? b : a;
  Dyadic sum = a_higher ? a : b;
  Integer& mantissa = DyadicParts::mantissa(sum);
  if (sum.exponent() != low.exponent()) mantissa <<= static_cast<unsigned long>(sum.exponent() - low.exponent());
  mantissa += mantissa_of(low);
  DyadicParts::exponent(sum) = low.exponent();
  return sum;
}

Dyadic operator-(const Dyadic& a, const Dyadic& b) {
  if (mantissa_of(a).is_zero()) return -b;
  if (mantissa_of(b).is_zero()) return a;
  const bool a_higher = a.exponent() > b.exponent();
  const Dyadic& low = a_higher ? b : a;
  Dyadic difference = a_higher ? a : b;
  Integer& mantissa = DyadicParts::mantissa(difference);
  if (difference.exponent() != low.exponent()) {
    mantissa <<= static_cast<unsigned long>(difference.exponent() - low.exponent());
  }
  mantissa -= mantissa_of(low);
  if (!a_higher) mantissa.backend().negate();
  DyadicParts::exponent(difference) = low.exponent();
  return difference;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  Dyadic product;
  boost::multiprecision::multiply(DyadicParts::mantissa(product), mantissa_of(a), mantissa_of(b));
  DyadicParts::exponent(product) = a.exponent() + b.exponent();
  return product;
}

double nearest_ratio(const Dyadic& numerator, const Dyadic& denominator) {
  SUNDER_REQUIRE(denominator.sign() != Sign::zero);
  if (numerator.sign() == Sign::zero) return 0;
  Integer n = boost::multiprecision::abs(mantissa_of(numerator));
  const Integer d = boost::multiprecision::abs(mantissa_of(denominator));
  // A quotient of at least 64 bits, and one more bit that tells whether a rest is left: it rounds as the fraction does.
  const std::int64_t shift = std::max<std::int64_t>(0, 65 - (bit_length(n) - bit_length(d)));
  n <<= static_cast<unsigned long>(shift);
  Integer quotient, rest;
  boost::multiprecision::divide_qr(n, d, quotient, rest);
  quotient = (quotient << 1) + (rest == 0 ? 0 : 1);
  const double size = dyadic_of(quotient, numerator.exponent() - denominator.exponent() - shift - 1).nearest();
  return numerator.sign() == denominator.sign() ? size : -size;
}

std::string fraction_text(const Dyadic& numerator, const Dyadic& denominator) {
  SUNDER_REQUIRE(denominator.sign() != Sign::zero);
  Integer n = mantissa_of(numerator);
  Integer d = mantissa_of(denominator);
  const std::int64_t shift = numerator.exponent() - denominator.exponent();
  if (n == 0) return "0";
  (shift > 0 ? n : d) <<= static_cast<unsigned long>(std::abs(shift));
  const Integer common = boost::multiprecision::gcd(n, d);
  n /= common;
  d /= common;
  if (d < 0) {
    n = -n;
    d = -d;
  }
  return d == 1 ? n.str() : n.str() + "/" + d.str();
}

}  // namespace sunder
