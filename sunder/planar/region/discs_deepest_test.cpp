#include <sunder/base/random.h>
#include <sunder/planar/region/discs_deepest.h>
#include <sunder/predicate/disc/disc_powers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunder::planar {
namespace {

// D1 to D3.
void expect_true(const std::vector<Disc>& circles, const DeepestPoint& deepest) {
  ASSERT_GE(deepest.count, 1u);
  ASSERT_LE(deepest.count, 3u);
  const DiscBasis basis = discs_of(circles, deepest.basis());
  ASSERT_EQ(deepest.power, deepest_power(basis));
  for (const Disc& c : circles) ASSERT_NE(power_against(basis, c), Sign::positive);
  const DeepestWeights weights = deepest_weights(basis);
  for (std::uint32_t k = 0; k < deepest.count; ++k) ASSERT_EQ(weights.numerators[k].sign(), Sign::positive);
}

DeepestPoint deepest(const std::vector<Disc>& circles) {
  const DeepestPoint front = discs_deepest(circles).point, by_order = discs_deepest_by_order(circles).point;
  expect_true(circles, front);
  expect_true(circles, by_order);
  EXPECT_EQ(front.power, by_order.power);
  return front;
}

TEST(DiscsDeepestTest, OneTwoAndThree) {
  EXPECT_EQ(deepest({{{1, 2}, 3}}).power, Sign::negative);
  EXPECT_EQ(deepest({{{1, 2}, 0}}).power, Sign::zero);
  EXPECT_EQ(deepest({{{0, 0}, 1}, {{2, 0}, 1}}).power, Sign::zero);
  EXPECT_EQ(deepest({{{0, 0}, 1}, {{2, 0}, std::nextafter(1, 2)}}).power, Sign::negative);
  EXPECT_EQ(deepest({{{0, 0}, 1}, {{2, 0}, std::nextafter(1, 0)}}).power, Sign::positive);
  EXPECT_EQ(deepest({{{0, 0}, 9}, {{1, 0}, 1}, {{0, 1}, 3}}).count, 1u);  // nested
  // Three through one point, that turn around it: only that point; or not.
  EXPECT_EQ(deepest({{{4, 3}, 5}, {{-3, 4}, 5}, {{3, 4}, 5}}).power, Sign::negative);
  EXPECT_EQ(deepest({{{4, 3}, 5}, {{-4, 3}, 5}, {{0, -5}, 5}}).power, Sign::zero);
  EXPECT_EQ(deepest({{{4, 3}, 5}, {{-4, 3}, 5}, {{0, -5}, std::nextafter(5, 0)}}).power, Sign::positive);
}

// What the proposal cannot find: overflow, underflow, ties everywhere.
TEST(DiscsDeepestTest, BeyondFloatingPoint) {
  EXPECT_EQ(deepest({{{-1.5e308, 0}, 1.5e308}, {{1.5e308, 0}, 1.5e308}}).power, Sign::zero);
  EXPECT_EQ(deepest({{{-1.5e308, 0}, 1.5e308}, {{1.5e308, 0}, 1.4e308}}).power, Sign::positive);
  EXPECT_EQ(deepest({{{0, 0}, 5e-324}, {{1e-323, 0}, 5e-324}}).power, Sign::zero);
  std::vector<Disc> equal(50, Disc{{0.1, 0.2}, 0.3});
  EXPECT_EQ(deepest(equal).count, 1u);
}

TEST(DiscsDeepestTest, RandomOnes) {
  Random random(3);
  int several = 0;
  for (int i = 0; i < 600; ++i) {
    std::vector<Disc> circles;
    const bool on_circle = i % 3 == 0;
    for (std::int64_t n = random.between(1, 60); n > 0; --n) {
      const double t = random.uniform(0, 7);
      circles.push_back(on_circle ? Disc{{std::cos(t), std::sin(t)}, 1}
                                  : Disc{{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(0, 2)});
    }
    several += deepest(circles).count > 1;
  }
  EXPECT_GT(several, 300);
}

TEST(DiscsDeepestTest, ProbesAreLinear) {
  for (std::uint32_t n = 1u << 4; n <= 1u << 18; n *= 4) {
    Random random(n);
    std::vector<Disc> circles, nearly_tied;
    for (std::uint32_t k = 0; k < n; ++k) {
      const double t = random.uniform(0, 7);
      circles.push_back({{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(1, 2)});
      if (n <= 1u << 14) nearly_tied.push_back({{std::cos(t), std::sin(t)}, 1.5});
    }
    EXPECT_LE(discs_deepest(circles).cost.probes, 12u * n + 100) << n;
    EXPECT_LE(discs_deepest_by_order(circles).cost.probes, 20u * n + 200) << n;
    if (!nearly_tied.empty()) {
      EXPECT_LE(discs_deepest(nearly_tied).cost.probes, 40u * n + 100) << n;
    }
  }
}

}  // namespace
}  // namespace sunder::planar
