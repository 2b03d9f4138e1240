#include <sunder/base/random.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/estimate.h>

#include <tests/support/doubles.h>

#include <gtest/gtest.h>

#include <cmath>

namespace sunder {
namespace {

using tests::largest;

// E1: |exact - value| <= error.
bool holds(const Estimate& x, const Dyadic& exact) {
  if (!std::isfinite(x.value.high) || !std::isfinite(x.value.low)) return !(x.error < HUGE_VAL);
  if (!std::isfinite(x.error)) return true;
  const Dyadic off = exact - (Dyadic(x.value.high) + Dyadic(x.value.low)), bound(x.error);
  return (off - bound).sign() != Sign::positive && (off + bound).sign() != Sign::negative;
}

double some_double(Random& random, int spread) {
  const double mantissa = random.below(8) == 0 ? static_cast<double>(random.between(-4, 4)) : random.uniform(-1, 1);
  return std::ldexp(mantissa, static_cast<int>(random.between(-spread, spread)));
}

// Random expressions of six steps, of numbers of like size, of all sizes, and of those next to both ends of the range.
TEST(EstimateTest, HoldsTheExactNumber) {
  Random random(3);
  int tight = 0, sure = 0, all = 0;
  for (int i = 0; i < 60000; ++i) {
    const int spread = i % 3 == 0 ? 3 : i % 3 == 1 ? 150 : 1020;
    const double first = some_double(random, spread);
    Estimate x(first);
    Dyadic exact(first);
    for (int step = 0; step < 6; ++step) {
      const double a = some_double(random, spread), b = some_double(random, spread);
      const Estimate y = Estimate(a) * Estimate(b) - Estimate(b);
      const Dyadic z = Dyadic(a) * Dyadic(b) - Dyadic(b);
      switch (random.below(3)) {
        case 0: x = x + y, exact = exact + z; break;
        case 1: x = x - y, exact = exact - z; break;
        default: x = x * y, exact = exact * z;
      }
      ASSERT_TRUE(holds(x, exact)) << i << " " << step << " " << x.value.high << " " << x.error;
    }
    ++all;
    const Guess guess = sign(x);
    if (is_sure(guess)) {
      ++sure;
      ASSERT_EQ(to_sign(guess), exact.sign()) << i;
    }
    tight += x.error <= 0x1p-80 * std::fabs(x.value.high);
  }
  EXPECT_GT(sure, all / 2);
  EXPECT_GT(tight, all / 3);
}

TEST(EstimateTest, TellsOnlyWhatIsSure) {
  EXPECT_EQ(sign(Estimate()), Guess::zero);
  EXPECT_EQ(sign(Estimate(5e-324)), Guess::positive);
  EXPECT_EQ(sign(Estimate(5e-324) * Estimate(0.25)), Guess::unsure);
  EXPECT_EQ(sign(Estimate(largest) + Estimate(largest)), Guess::unsure);
  EXPECT_EQ(sign(Estimate(largest) * Estimate(0.5) - Estimate(1)), Guess::unsure);
  // A difference in the last of 100 bits, and one beyond.
  const Estimate one(1), less = Estimate(1) - Estimate(0x1p-60);
  EXPECT_EQ(sign(one - less * less - Estimate(0x1p-59)), Guess::unsure);
  EXPECT_EQ(sign(one - less), Guess::positive);
  EXPECT_EQ(sign(less - one), Guess::negative);
}

}  // namespace
}  // namespace sunder
