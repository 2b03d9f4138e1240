#include <sunder/base/random.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace sunder {
namespace {

TEST(RandomTest, KnownStream) {
  // SplitMix64 as published, from seed 1234567.
  Random random(1234567);
  for (const std::uint64_t expected : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                       4593380528125082431u, 16408922859458223821u}) {
    EXPECT_EQ(random.next(), expected);
  }
  Random zero(0);
  EXPECT_EQ(zero.next(), 0xe220a8397b1dcdafu);
}

TEST(RandomTest, EqualSeedsGiveEqualStreams) {
  Random a(7), b(7), c(8);
  bool differ = false;
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t x = a.next();
    EXPECT_EQ(x, b.next());
    differ = differ || x != c.next();
  }
  EXPECT_TRUE(differ);
}

TEST(RandomTest, IntegersReachBothEndsEvenly) {
  Random random(1);
  std::array<int, 7> below{}, between{};
  for (int i = 0; i < 70000; ++i) {
    ++below[random.below(7)];
    const std::int64_t x = random.between(-3, 3);
    ASSERT_TRUE(-3 <= x && x <= 3);
    ++between[static_cast<std::size_t>(x + 3)];
  }
  for (std::size_t i = 0; i < 7; ++i) {  // 10,000 each; the standard deviation is 93
    EXPECT_NEAR(below[i], 10000, 600);
    EXPECT_NEAR(between[i], 10000, 600);
  }
  EXPECT_EQ(random.between(5, 5), 5);
  constexpr std::int64_t half = std::numeric_limits<std::int64_t>::max() / 2;
  for (int i = 0; i < 100; ++i) {
    const std::int64_t x = random.between(-half, half);
    EXPECT_TRUE(-half <= x && x <= half);
  }
}

TEST(RandomTest, UnitIsInRangeAndAMultipleOf2ToMinus53) {
  Random random(2);
  double sum = 0, lowest = 1, highest = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.unit();
    ASSERT_TRUE(0 <= x && x < 1);
    ASSERT_EQ(std::fmod(x * 0x1p53, 1), 0);
    sum += x;
    lowest = std::min(lowest, x);
    highest = std::max(highest, x);
  }
  EXPECT_NEAR(sum / 20000, 0.5, 0.015);  // the standard deviation of the mean is 0.002
  EXPECT_LT(lowest, 0.001);
  EXPECT_GT(highest, 0.999);
}

TEST(RandomTest, UniformAndLogUniform) {
  Random random(3);
  int low_half = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-3, 5);
    ASSERT_TRUE(-3 <= x && x <= 5);
    const double y = random.log_uniform(1e-6, 1e2);
    ASSERT_TRUE(1e-6 * (1 - 1e-12) <= y && y <= 1e2 * (1 + 1e-12));
    if (y < 1e-2) ++low_half;
  }
  EXPECT_NEAR(low_half, 10000, 450);
}

TEST(RandomTest, LogUniformOverTheWholeRange) {
  Random random(4);
  int low_half = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.log_uniform(1e-300, 1e300);
    ASSERT_TRUE(0.99e-300 <= x && x <= 1.01e300);
    if (x < 1) ++low_half;
  }
  EXPECT_NEAR(low_half, 10000, 450);
}

}  // namespace
}  // namespace sunder
