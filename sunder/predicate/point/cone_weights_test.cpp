#include <sunder/base/random.h>
#include <sunder/number/dyadic.h>
#include <sunder/predicate/point/cone_weights.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace sunder {
namespace {

// A direction made of small integer weights of generators of small integers: the weights are known.
TEST(ConeWeights, SignsAreThoseOfTheWeights) {
  Random random(1);
  int sure = 0, unsure = 0;
  for (int turn = 0; turn < 5000; ++turn) {
    const std::size_t d = 2 + random.below(6);
    std::vector<double> generators(d * d), inverse(d * d), direction(d), weights(d);
    for (double& x : generators) x = std::ldexp(static_cast<double>(random.between(-9, 9)), turn % 3 * 40);
    const double slack = cone_inverse(generators, d, inverse);
    if (!std::isfinite(slack)) continue;
    EXPECT_LT(slack, 1);
    for (std::size_t i = 0; i < d; ++i) {
      weights[i] = static_cast<double>(random.between(-3, 3));
      for (std::size_t r = 0; r < d; ++r) direction[r] += weights[i] * generators[i * d + r];
    }
    const ConeWeights found = cone_weights(inverse, slack, direction, d);
    for (std::size_t i = 0; i < d; ++i) {
      const Guess sign = found.sign[i];
      if (sign == Guess::unsure) {
        ++unsure;
        EXPECT_NEAR(found.weight[i], weights[i], 1e-3);
        continue;
      }
      ++sure;
      EXPECT_EQ(to_sign(sign), sign_of(weights[i]));
    }
  }
  EXPECT_GT(sure, unsure);
  EXPECT_GT(unsure, 100);  // zeros
}

TEST(ConeWeights, FlatConesHaveNoInverse) {
  std::vector<double> inverse(9);
  EXPECT_EQ(cone_inverse(std::vector<double>{1, 2, 3, 2, 4, 6, 0, 1, 0}, 3, inverse),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(cone_inverse(std::vector<double>{1, 0, 0, 0, 1, 0, 1, 1, 0}, 3, inverse),
            std::numeric_limits<double>::infinity());
}

TEST(ConeWeights, DifferencesAreEnclosed) {
  Random random(2);
  for (int turn = 0; turn < 5000; ++turn) {
    const std::size_t d = 2 + random.below(6);
    std::vector<double> g(d), v(d), w(d);
    const double scale = std::ldexp(1.0, static_cast<int>(random.between(-600, 480)));
    Dyadic exact;
    for (std::size_t c = 0; c < d; ++c) {
      g[c] = random.uniform(-1, 1);
      v[c] = scale * random.uniform(-1, 1);
      w[c] = turn % 2 == 0 ? v[c] * (1 + 0x1p-50 * random.unit()) : scale * random.uniform(-1, 1);
      exact = exact + Dyadic(g[c]) * (Dyadic(v[c]) - Dyadic(w[c]));
    }
    const ProductRange range = difference_along(g, v, w);
    EXPECT_NE((exact - Dyadic(range.least)).sign(), Sign::negative);
    EXPECT_NE((exact - Dyadic(range.most)).sign(), Sign::positive);
    EXPECT_LE(range.most - range.least, 1e-13 * scale + 0x1p-1050);
  }
  constexpr double huge = 0x1p1023;
  const ProductRange range =
      difference_along(std::vector<double>{1, 1}, std::vector<double>{huge, 0}, std::vector<double>{-huge, 0});
  EXPECT_EQ(range.most, std::numeric_limits<double>::infinity());
  EXPECT_EQ(range.least, -range.most);
}

}  // namespace
}  // namespace sunder
