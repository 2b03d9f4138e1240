#include <sunder/number/rounded_elimination_internal.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sunder {
namespace {

TEST(RoundedElimination, TakesTheGreatestOfAllThatAreLeft) {
  RoundedElimination m(3, 3);
  m[0] = {1, 2, 3};
  m[1] = {2, 4, 6};
  m[2] = {1, 0, 8};
  EXPECT_EQ(m.step(0), 2u);
  EXPECT_EQ(m.column(0), 2u);
  EXPECT_EQ(m.pivot(0), 8);
  // Left: rows 1 and 0 without their part of the last row, in columns 0 and 1.
  EXPECT_EQ(m.step(0), 1u);
  EXPECT_EQ(m.column(1), 1u);
  EXPECT_EQ(m.pivot(1), 4);
  EXPECT_EQ(m.row(1)[0], 1.25);
  EXPECT_EQ(m.column(2), 0u);
  EXPECT_FALSE(m.step(0x1p-40).has_value());
  EXPECT_EQ(m.rank(), 2u);
}

TEST(RoundedElimination, OfEqualOnesTheFirst) {
  RoundedElimination m(2, 3);
  m[0] = {0, -1, 1};
  m[1] = {1, 1, 1};
  EXPECT_EQ(m.step(0), 0u);
  EXPECT_EQ(m.column(0), 1u);
  EXPECT_EQ(m.step(0), 1u);
  EXPECT_EQ(m.column(1), 2u);
  EXPECT_EQ(m.column(2), 0u);
  EXPECT_EQ(m.pivot(1), 2);
}

TEST(RoundedElimination, InfiniteNumbersAreNoPivots) {
  RoundedElimination m(1, 2);
  m[0] = {1, HUGE_VAL};
  EXPECT_FALSE(m.step(0).has_value());
}

TEST(RoundedInverse, IsTheInverse) {
  const std::array<double, 4> m{0, 2, 4, 0x1p60};
  std::array<double, 4> inverse{};
  ASSERT_TRUE(rounded_inverse(2, m, inverse));
  EXPECT_EQ(inverse, (std::array<double, 4>{-0x1p57, 0.25, 0.5, 0}));
  EXPECT_FALSE(rounded_inverse(2, std::array<double, 4>{1, 2, 2, 4}, inverse));
  EXPECT_FALSE(rounded_inverse(2, std::array<double, 4>{1, 2, 0, 0}, inverse));
}

}  // namespace
}  // namespace sunder
