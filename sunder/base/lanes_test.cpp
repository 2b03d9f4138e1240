#include <sunder/base/lanes.h>
#include <sunder/base/random.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace sunder {
namespace {

TEST(LanesTest, LaneByLane) {
  const std::array<double, 3> numbers{5, 2, -3};
  const Lanes a = lanes_at(numbers.data()), b = lanes_at(numbers.data() + 1);  // of any alignment
  EXPECT_EQ(a[0], 5);
  EXPECT_EQ(a[1], 2);
  EXPECT_EQ(greater_of(a, b)[0], 5);
  EXPECT_EQ(greater_of(b, a)[1], 2);
  EXPECT_EQ(greater_lane(a), 5);
  EXPECT_EQ(greater_lane(swapped(a)), 5);
  EXPECT_EQ(swapped(b)[0], -3);
  EXPECT_EQ(swapped(b)[1], 2);
  EXPECT_EQ(absolute(b)[0], 2);
  EXPECT_EQ(absolute(b)[1], 3);
  EXPECT_EQ(absolute(Lanes{-0.0, 0.0})[0], 0);
}

TEST(LanesTest, FirstOfGreatest) {
  Random random(5);
  int ties = 0;
  for (std::uint32_t count = 2; count <= 16; count += 2) {
    for (int i = 0; i < 2000; ++i) {
      std::array<double, 32> numbers{};
      for (double& x : numbers) x = static_cast<double>(random.between(-4, 4));  // so that many are equal
      std::array<Lanes, 16> values;
      for (std::size_t k = 0; k < 16; ++k) values[k] = lanes_at(&numbers[2 * k]);
      std::uint32_t expected = 0, equal = 0;
      for (std::uint32_t k = 0; k < 2 * count; ++k) {
        if (numbers[k] > numbers[expected]) expected = k;
      }
      for (std::uint32_t k = 0; k < 2 * count; ++k) equal += numbers[k] == numbers[expected];
      ties += equal > 1;
      ASSERT_EQ(first_of_greatest(values.data(), count), expected) << count;
    }
  }
  EXPECT_GT(ties, 4000);
}

TEST(LanesTest, FirstOfGreatestStaysInRangeWhateverItReads) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const std::array<double, 4> odd{nan, infinity, -infinity, 1};
  for (int i = 0; i < 256; ++i) {
    std::array<double, 4> numbers{};
    for (std::size_t k = 0; k < 4; ++k) numbers[k] = odd[static_cast<std::size_t>(i >> 2 * k & 3)];
    const std::array<Lanes, 2> values{lanes_at(numbers.data()), lanes_at(numbers.data() + 2)};
    ASSERT_LT(first_of_greatest(values.data(), 2), 4u);
  }
}

TEST(LanesTest, IsAtMost) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(bits_of(is_at_most(Lanes{1, 2}, Lanes{1, 1})), 1u);  // equal counts
  EXPECT_EQ(bits_of(is_at_most(Lanes{2, 1}, Lanes{1, 2})), 2u);
  EXPECT_EQ(bits_of(is_at_most(Lanes{nan, 1}, Lanes{1, nan})), 0u);  // so boxes that are not there meet none
  EXPECT_EQ(bits_of(is_at_most(Lanes{-0.0, 0.0}, Lanes{0.0, -0.0}) & is_at_most(Lanes{1, 2}, Lanes{1, 1})), 1u);
}

TEST(LanesTest, RootsAreThoseOfSingleDoubles) {
  Random random(12);
  for (int i = 0; i < 1000; ++i) {
    const double a = std::ldexp(random.uniform(0, 1), static_cast<int>(random.between(-1070, 1020))), b = 2 * a;
    const Lanes roots = root_of(Lanes{a, b});
    ASSERT_EQ(roots[0], std::sqrt(a));
    ASSERT_EQ(roots[1], std::sqrt(b));
  }
}

TEST(LanesTest, SmallerAndBits) {
  const Lanes a{1, 4}, b{2, 3}, smaller = smaller_of(a, b);
  EXPECT_EQ(smaller[0], 1);
  EXPECT_EQ(smaller[1], 3);
  EXPECT_EQ(bits_of(a < b), 1u);
  EXPECT_EQ(bits_of(a > b), 2u);
  EXPECT_EQ(bits_of(a == b), 0u);
  EXPECT_EQ(bits_of(a != b), 3u);
}

}  // namespace
}  // namespace sunder
