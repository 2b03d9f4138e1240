// Against the exact coordinates of deepest points; and these against what they are said to be.
#include <sunder/base/random.h>
#include <sunder/predicate/disc/disc_powers.h>
#include <sunder/predicate/point/orient.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace sunder {
namespace {

// Times the square of the point's denominator, which is positive.
Dyadic power(const ExactPoint2& p, const Disc& d) {
  const Dyadic x = p.x - Dyadic(d.center.x) * p.denominator, y = p.y - Dyadic(d.center.y) * p.denominator;
  const Dyadic r = Dyadic(d.radius) * p.denominator;
  return x * x + y * y - r * r;
}

class PowerDiscSource {
 public:
  explicit PowerDiscSource(std::uint64_t seed) : random(seed) {}

  Disc disc(int kind) {
    const auto whole = [&](std::int64_t low, std::int64_t high) {
      return static_cast<double>(random.between(low, high));
    };
    switch (kind) {
      case 0: return {{whole(-3, 3), whole(-3, 3)}, whole(0, 4)};
      case 1: return {{random.uniform(-1, 1), random.uniform(-1, 1)}, random.unit()};
      case 2: {  // on one circle but for the last bits
        const double t = random.uniform(0, 7);
        return {{std::cos(t), std::sin(t)}, 2};
      }
      default: {
        const auto any = [&] { return random.log_uniform(1e-300, 1e300) * (random.below(2) ? 1 : -1); };
        const double x = any(), y = any();
        return {{x, y}, std::fabs(any())};
      }
    }
  }

  Random random;
};

TEST(DiscPowersTest, AgainstExactPoints) {
  PowerDiscSource source(9);
  std::array<StageTally, 4> tallies;
  std::array<int, 3> signs{};
  const auto count = static_cast<std::uint64_t>(tests::scaled_count(16000, 3200));
  for (std::uint64_t i = 0; i < count; ++i) {
    const int kind = static_cast<int>(i % 4);
    std::vector<Disc> basis;
    for (std::uint64_t n = 1 + i / 4 % 3; n > 0; --n) basis.push_back(source.disc(kind));
    if (basis.size() > 1 && basis[0].center == basis[1].center) continue;
    if (basis.size() > 2 && orient_2d(basis[0].center, basis[1].center, basis[2].center) == Sign::zero) continue;
    const ExactPoint2 p = deepest_point(basis);
    ASSERT_EQ(p.denominator.sign(), Sign::positive);
    const Dyadic common = power(p, basis[0]);
    for (const Disc& d : basis) ASSERT_EQ(power(p, d), common) << i;
    StageTally& tally = tallies[static_cast<std::size_t>(kind)];
    ASSERT_EQ(deepest_power(basis, &tally), common.sign()) << i;
    const Disc k = source.random.below(8) == 0 ? basis.back() : source.disc(kind);
    const Sign against = power_against(basis, k, &tally);
    ASSERT_EQ(against, (power(p, k) - common).sign()) << i;
    ++signs[static_cast<std::size_t>(static_cast<std::int8_t>(against) + 1)];
    if (is_surely_less(k, power_bound(basis))) {
      ASSERT_EQ(against, Sign::negative) << i;
    }

    // The weights: of sum one, and the point is their sum of centres.
    const DeepestWeights w = deepest_weights(basis);
    Dyadic sum, x, y;
    for (std::size_t m = 0; m < basis.size(); ++m) {
      sum = sum + w.numerators[m];
      x = x + w.numerators[m] * Dyadic(basis[m].center.x);
      y = y + w.numerators[m] * Dyadic(basis[m].center.y);
    }
    ASSERT_EQ(sum, w.denominator) << i;
    ASSERT_EQ(x * p.denominator, p.x * w.denominator) << i;
    ASSERT_EQ(y * p.denominator, p.y * w.denominator) << i;

    // Cut to some bits, it is that near.
    const Viewpoint cut = deepest_viewpoint(basis, 100);
    const Dyadic off = cut.x * p.denominator - p.x, size = Dyadic(0x1p-98) * p.denominator;
    const double most = std::max({std::fabs(cut.x.nearest()), std::fabs(cut.y.nearest()), 1e-320});
    if (std::isfinite(most)) {
      ASSERT_NE((off * off - Dyadic(most) * Dyadic(most) * size * size).sign(), Sign::positive) << i;
    }

    const Point2 at = source.disc(kind).center;
    ASSERT_EQ(power_at(at, k), power({at.x, at.y, Dyadic(1)}, k).sign()) << i;
    ASSERT_EQ(power_at(viewpoint(at), k), power_at(at, k)) << i;
  }
  for (const int n : signs) EXPECT_GT(n, static_cast<int>(count / 32));
  EXPECT_GT(tallies[0].rounded + tallies[0].interval, count * 3 / 16);
  EXPECT_GT(tallies[0].exact, count * 3 / 160);
  EXPECT_GT(tallies[1].rounded, count * 5 / 16);
  EXPECT_GT(tallies[2].interval, count / 32);  // numbers of 106 bits
}

TEST(DiscPowersTest, BoundsOfBoxes) {
  Random random(10);
  int sure = 0, left = 0;
  for (int i = 0; i < 20000; ++i) {
    const Disc d{{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(0, 3)};
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), wide = random.log_uniform(1e-16, 1);
    const Enclosure2 box{{x, x + wide}, {y, y + wide}};
    if (!is_surely_less(d, {box, 0})) {
      ++left;
      continue;
    }
    ++sure;
    for (const Point2 corner :
         {Point2{box.x.low, box.y.low}, {box.x.high, box.y.low}, {box.x.low, box.y.high}, {box.x.high, box.y.high}}) {
      ASSERT_EQ(power_at(corner, d), Sign::negative) << i;
    }
  }
  EXPECT_GT(sure, 5000);
  EXPECT_GT(left, 3000);
}

}  // namespace
}  // namespace sunder
