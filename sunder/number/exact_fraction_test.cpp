#include <sunder/number/exact_fraction.h>
#include <sunder/number/root.h>

#include <gtest/gtest.h>

#include <cmath>

namespace sunder {
namespace {

ExactFraction over(double n, double d) { return {Dyadic(n), Dyadic(d)}; }

TEST(ExactFraction, OrderIsThatOfTheValues) {
  EXPECT_LT(over(1, 3), over(1, 2));
  EXPECT_GT(over(-1, 3), over(-1, 2));
  EXPECT_EQ(over(2, 6), over(1, 3));
  EXPECT_NE(over(2, 6), over(1, 4));
  EXPECT_LE(over(0, 5), over(0, 7));
  EXPECT_EQ(compare(over(3, 0x1p-1000), over(3, 0x1p1000)), Sign::positive);
  EXPECT_EQ(compare(over(1, 3), over(2, 3)), Sign::negative);
}

TEST(ExactFraction, DenominatorsArePositive) {
  const ExactFraction x = ExactFraction::quotient(1.0, -3.0);
  EXPECT_EQ(x.denominator.sign(), Sign::positive);
  EXPECT_EQ(x.text(), "-1/3");
  EXPECT_EQ(ExactFraction::quotient(1.0, 3.0).text(), "1/3");
}

TEST(ExactFraction, MiddleAndEnclosure) {
  EXPECT_EQ(middle(over(1, 3), over(1, 2)), over(5, 12));
  EXPECT_EQ(over(1, 4).enclosure().low, 0.25);
  EXPECT_EQ(over(1, 4).enclosure().high, 0.25);
  for (const double sign : {1.0, -1.0}) {
    const auto [low, high] = over(sign, 3).enclosure();
    EXPECT_EQ(high, std::nextafter(low, HUGE_VAL));
    EXPECT_LT(ExactFraction{Dyadic(low)}, over(sign, 3));
    EXPECT_GT(ExactFraction{Dyadic(high)}, over(sign, 3));
  }
}

TEST(ExactFraction, RootsAreCompared) {
  EXPECT_EQ(compare_root(over(9, 4), 1.5), Sign::zero);
  EXPECT_EQ(compare_root(over(2, 1), 1.5), Sign::negative);
  EXPECT_EQ(compare_root(over(7, 3), 1.5), Sign::positive);
  EXPECT_EQ(root(over(9, 4)).low, 1.5);
  EXPECT_EQ(root(over(9, 4)).high, 1.5);
}

}  // namespace
}  // namespace sunder
