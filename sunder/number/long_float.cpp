#include <sunder/base/contract.h>
#include <sunder/number/integer_internal.h>
#include <sunder/number/long_float_internal.h>

#include <algorithm>
#include <utility>

namespace sunder {

namespace {

std::int64_t length(const Dyadic& x) { return x.top() - x.exponent() + 1; }

}  // namespace

Dyadic LongFloats::rounded(Dyadic x) const {
  const std::int64_t over = x.sign() == Sign::zero ? 0 : length(x) - bits;
  if (over <= 0) return x;
  // Only the absolute value is shifted: for some negative numbers, a right shift of Boost 1.74 returns a positive one.
  Integer size = boost::multiprecision::abs(mantissa_of(x)) >> static_cast<unsigned>(over - 1);
  ++size;  // to the nearest
  size >>= 1;
  if (x.sign() == Sign::negative) size.backend().negate();
  return dyadic_of(std::move(size), x.exponent() + over);
}

Dyadic LongFloats::sum(const Dyadic& a, const Dyadic& b) const {
  if (a.sign() == Sign::zero) return b;
  if (b.sign() == Sign::zero) return a;
  const std::int64_t top_a = a.top(), top_b = b.top();
  if (top_a > top_b + bits) return a;
  if (top_b > top_a + bits) return b;
  Dyadic sum = a + b;
  if (sum.sign() == Sign::zero || sum.top() < std::max(top_a, top_b) - bits / 2) return {};
  return rounded(std::move(sum));
}

Dyadic LongFloats::quotient(const Dyadic& a, const Dyadic& b) const {
  SUNDER_REQUIRE(b.sign() != Sign::zero);
  if (a.sign() == Sign::zero) return {};
  const std::int64_t shift = std::max<std::int64_t>(0, bits + 1 + length(b) - length(a));
  Integer quotient = mantissa_of(a) << static_cast<unsigned>(shift);
  quotient /= mantissa_of(b);
  return rounded(dyadic_of(std::move(quotient), a.exponent() - b.exponent() - shift));
}

}  // namespace sunder
