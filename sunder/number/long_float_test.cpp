#include <sunder/base/random.h>
#include <sunder/number/long_float_internal.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace sunder {
namespace {

// |x - exact| < 2^-bits |exact|, up to a factor.
bool is_near(const Dyadic& x, const Dyadic& exact, std::int64_t bits) {
  const Dyadic error = x - exact;
  return error.sign() == Sign::zero || (exact.sign() != Sign::zero && error.top() <= exact.top() - bits + 2);
}

TEST(LongFloats, AreWithinALastBit) {
  Random random(20261206);
  for (int turn = 0; turn < 3000; ++turn) {
    const LongFloats to{static_cast<std::int64_t>(40 + random.below(400))};
    const auto some = [&] {
      Dyadic x = random.uniform(-1, 1);
      for (std::uint64_t k = random.below(8); k > 0; --k) x = x * Dyadic(random.uniform(-1, 1)) + Dyadic(0x1p-70);
      return to.rounded(x.scaled(random.between(-5000, 5000)));
    };
    const Dyadic a = some(), b = some();
    const auto is_sum = [&](const Dyadic& x, const Dyadic& exact) {
      return x.sign() == Sign::zero
                 ? exact.sign() == Sign::zero || exact.top() < std::max(a.top(), b.top()) - to.bits / 2
                 : is_near(x, exact, to.bits);
    };
    EXPECT_TRUE(is_sum(to.sum(a, b), a + b));
    EXPECT_TRUE(is_sum(to.difference(a, b), a - b));
    EXPECT_TRUE(is_near(to.product(a, b), a * b, to.bits));
    EXPECT_TRUE(is_near(to.quotient(a, b) * b, a, to.bits));
    EXPECT_LE(to.product(a, b).top() - to.product(a, b).exponent() + 1, to.bits);
  }
}

TEST(LongFloats, KeepSigns) {
  for (const std::int64_t bits : {60, 700, 1000}) {
    const LongFloats to{bits};
    const Dyadic x = Dyadic(-3.0).scaled(2 * bits) - Dyadic(1.0);
    EXPECT_EQ(to.rounded(x), Dyadic(-3.0).scaled(2 * bits));
    EXPECT_EQ(to.rounded(-x), Dyadic(3.0).scaled(2 * bits));
  }
}

TEST(LongFloats, WhatCancelsToRoundingsIsZero) {
  const LongFloats to{100};
  const Dyadic one = 1.0;
  EXPECT_EQ(to.difference(one + Dyadic(0x1p-55), one).sign(), Sign::zero);
  EXPECT_EQ(to.difference(one + Dyadic(0x1p-45), one).sign(), Sign::positive);
  EXPECT_EQ(to.difference(one, one).sign(), Sign::zero);
  EXPECT_EQ(to.difference({}, one).sign(), Sign::negative);
  EXPECT_EQ(to.quotient({}, one).sign(), Sign::zero);
}

}  // namespace
}  // namespace sunder
