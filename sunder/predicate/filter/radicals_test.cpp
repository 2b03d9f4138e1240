// Against whole numbers: roots cut to 2^-400, which no sum of the numbers here that is not zero comes near.
#include <sunder/base/random.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/rounded.h>
#include <sunder/predicate/filter/radicals.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <array>

namespace sunder {
namespace {

using Whole = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

constexpr unsigned root_bits = 400;

Whole root(std::int64_t p) { return boost::multiprecision::sqrt(Whole(p) << (2 * root_bits)); }

// Of a number times 2^bits, off by less than 2^40.
Guess sign_of_cut(const Whole& x) {
  if (boost::multiprecision::abs(x) < Whole(1) << 60) return Guess::zero;
  return x > 0 ? Guess::positive : Guess::negative;
}

struct Numbers {
  std::int64_t a, b, c, d, p, q;
};

Guess expected(const Numbers& n) {
  return sign_of_cut((Whole(n.a) << root_bits) + n.b * root(n.p) + n.c * root(n.q) + n.d * root(n.p * n.q));
}

template <class T>
Guess found(const Numbers& n) {
  const auto number = [](std::int64_t x) { return T(static_cast<double>(x)); };
  return sign_with_roots(number(n.a), number(n.b), number(n.c), number(n.d), number(n.p), number(n.q));
}

TEST(RadicalsTest, AgainstRootsOfManyBits) {
  Random random(5);
  std::array<int, 3> signs{};
  int sure = 0, zero_by_roots = 0;
  const int count = tests::scaled_count(40000, 4000);
  for (int i = 0; i < count; ++i) {
    const std::int64_t size = i % 3 == 0 ? 3 : i % 3 == 1 ? 12 : 1000;
    const auto any = [&] { return random.between(-size, size); };
    Numbers n{any(), any(), any(), any(), random.between(0, size), random.between(0, size)};
    if (random.below(2)) {  // equal roots, or multiples of one another, with which sums can be zero
      const std::int64_t k = random.between(1, 3);
      n.q = n.p * k * k;
      if (random.below(2)) n.b = -k * n.c;
      if (random.below(2)) n.a = -n.d * k * n.p;
    }
    const Guess sign = expected(n);
    ASSERT_EQ(found<Dyadic>(n), sign) << n.a << " " << n.b << " " << n.c << " " << n.d << " " << n.p << " " << n.q;
    ++signs[static_cast<std::size_t>(static_cast<std::int8_t>(sign) + 1)];
    zero_by_roots += sign == Guess::zero && (n.b != 0 || n.c != 0) && n.p > 0 && n.q > 0;
    const Guess by_interval = found<Interval>(n);
    if (!is_sure(by_interval)) continue;
    ++sure;
    ASSERT_EQ(by_interval, sign);
  }
  for (const int of_sign : signs) EXPECT_GT(of_sign, count / 20);
  EXPECT_GT(zero_by_roots, count / 50);
  EXPECT_GT(sure, count / 2);
}

// What is only known to be nearly zero must not tell a sign.
TEST(RadicalsTest, UnsureStaysUnsure) {
  const Interval near_zero(-1e-20, 1e-20), one(1), none(0.0);
  EXPECT_EQ(sign_with_root(none, one, near_zero), Guess::unsure);
  EXPECT_EQ(sign_with_root(one, one, near_zero), Guess::positive);
  EXPECT_EQ(sign_with_root(one, -one, near_zero), Guess::positive);
  EXPECT_EQ(sign_with_root(near_zero, one, one), Guess::unsure);
  EXPECT_EQ(sign_with_root(none, one, one), Guess::positive);
  EXPECT_EQ(sign_with_root(none, none, near_zero), Guess::zero);
  EXPECT_EQ(sign_with_roots(none, none, none, one, near_zero, one), Guess::unsure);
  EXPECT_EQ(sign_with_roots(none, none, one, none, one, near_zero), Guess::unsure);
}

// Of square_root in number/interval.h: it holds the root of each member, and is not much wider.
TEST(RadicalsTest, RootsOfIntervals) {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.log_uniform(1e-300, 1e300), y = x * (1 + random.unit() * (random.below(2) ? 1 : 1e-15));
    const Interval root = square_root(Interval(x, y));
    const Dyadic low = root.low, high = root.high;
    ASSERT_NE((low * low - Dyadic(x)).sign(), Sign::positive);
    ASSERT_NE((high * high - Dyadic(y)).sign(), Sign::negative);
    ASSERT_GE(root.low, std::sqrt(x) * (1 - 0x1p-50));
    ASSERT_LE(root.high, std::sqrt(y) * (1 + 0x1p-50));
  }
  const Interval of_unsure = square_root(Interval(-1e-10, 4));
  EXPECT_EQ(of_unsure.low, 0);
  EXPECT_GE(of_unsure.high, 2);
}

}  // namespace
}  // namespace sunder
