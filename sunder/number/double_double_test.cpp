// Against exact numbers.
#include <sunder/base/random.h>
#include <sunder/number/double_double.h>
#include <sunder/number/dyadic.h>

#include <gtest/gtest.h>

#include <cmath>

namespace sunder {
namespace {

Dyadic exact(const DoubleDouble& x) { return Dyadic(x.high) + Dyadic(x.low); }

Dyadic size_of(const Dyadic& x) { return x.sign() == Sign::negative ? -x : x; }

// |found - expected| <= 2^exponent |scale|
void expect_near(const Dyadic& found, const Dyadic& expected, const Dyadic& scale, int exponent) {
  const Dyadic off = size_of(found - expected), allowed = size_of(scale) * Dyadic(std::ldexp(1.0, exponent));
  EXPECT_NE((allowed - off).sign(), Sign::negative);
}

DoubleDouble some_double_double(Random& random) {
  const double high = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.between(-40, 40)));
  return exact_sum(high, high * random.uniform(-1, 1) * 0x1p-54);
}

TEST(DoubleDoubleTest, SumsAndProductsOfDoublesAreExact) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const double a = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.between(-60, 60)));
    const double b = random.below(8) == 0 ? -a * (1 + 0x1p-52) : random.uniform(-1, 1);
    ASSERT_EQ((exact(exact_sum(a, b)) - (Dyadic(a) + Dyadic(b))).sign(), Sign::zero);
    ASSERT_EQ(exact_sum(a, b).high, a + b);
    ASSERT_EQ((exact(exact_product(a, b)) - Dyadic(a) * Dyadic(b)).sign(), Sign::zero);
    ASSERT_EQ(exact_product(a, b).high, a * b);
  }
}

TEST(DoubleDoubleTest, ArithmeticIsGoodToAHundredBits) {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = some_double_double(random), b = some_double_double(random);
    const Dyadic x = exact(a), y = exact(b);
    expect_near(exact(a + b), x + y, size_of(x) + size_of(y), -103);
    expect_near(exact(a - b), x - y, size_of(x) + size_of(y), -103);
    expect_near(exact(a * b), x * y, x * y, -102);
    expect_near(exact(a / b) * y, x, x, -100);
    ASSERT_EQ(a < b, (x - y).sign() == Sign::negative);
    ASSERT_EQ(a > b, (x - y).sign() == Sign::positive);
    ASSERT_EQ(a >= b, (x - y).sign() != Sign::negative);
    ASSERT_TRUE(a >= a && a == a && !(a < a) && !(a == a + DoubleDouble(a.high * 0x1p-80)));
    ASSERT_EQ(exact(magnitude(a)).sign(), Sign::positive);
    ASSERT_EQ(nearest(a), a.high);
    if (HasFailure()) FAIL() << i;
  }
}

TEST(DoubleDoubleTest, DiffersInTheLowerHalfOnly) {
  const DoubleDouble one(1), more = one + DoubleDouble(0x1p-90);
  EXPECT_TRUE(one < more);
  EXPECT_TRUE(more > one);
  EXPECT_FALSE(one >= more);
  EXPECT_EQ(nearest(more), 1);
  EXPECT_EQ(nearest(more - one), 0x1p-90);
}

}  // namespace
}  // namespace sunder
