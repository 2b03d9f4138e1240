#include <sunder/base/random.h>
#include <sunder/polytope/represent/normal_fan.h>
#include <sunder/predicate/point/cone_weights.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sunder::polytope {
namespace {

std::vector<double> points_in_cube(Random& random, std::size_t d, std::size_t count) {
  std::vector<double> points;
  for (std::size_t k = 0; k < d * count; ++k) points.push_back(random.uniform(-1, 1));
  return points;
}

// Each direction has one cone, along which its apex is the furthest point: Lemma 6.1.
TEST(NormalFan, EachDirectionHasOneConeAndItsApexIsFurthest) {
  Random random(1);
  for (std::size_t d = 2; d <= 6; ++d) {
    const std::size_t count = d < 5 ? 14 : 10;
    const std::vector<double> points = points_in_cube(random, d, count);
    const auto fan = normal_fan(d, points);
    ASSERT_TRUE(fan);
    for (const NormalFan::Cone& cone : fan->cones) {
      for (std::size_t i = 0; i < d; ++i) {
        const auto& across = fan->cones[cone.across[i]].across;
        EXPECT_EQ(std::count_if(across.begin(), across.begin() + static_cast<std::ptrdiff_t>(d),
                                [&](std::uint32_t k) { return &fan->cones[k] == &cone; }),
                  1);
      }
    }
    for (int turn = 0; turn < 100; ++turn) {
      std::vector<double> direction(d);
      for (double& x : direction) x = random.uniform(-1, 1);
      int having = 0;
      std::size_t apex = 0, furthest = 0;
      double greatest = -1e9;
      for (std::size_t k = 0; k < count; ++k) {
        double sum = 0;
        for (std::size_t c = 0; c < d; ++c) sum += direction[c] * points[k * d + c];
        if (sum > greatest) {
          greatest = sum;
          furthest = k;
        }
      }
      for (const NormalFan::Cone& cone : fan->cones) {
        std::vector<double> rays, inverse(d * d);
        for (std::size_t i = 0; i < d; ++i)
          rays.insert(rays.end(), fan->ray(cone.rays[i]).begin(), fan->ray(cone.rays[i]).end());
        const ConeWeights weights = cone_weights(inverse, cone_inverse(rays, d, inverse), direction, d);
        if (std::all_of(weights.sign.begin(), weights.sign.begin() + static_cast<std::ptrdiff_t>(d),
                        [](Guess g) { return g == Guess::positive; })) {
          ++having;
          apex = cone.apex;
        }
      }
      EXPECT_EQ(having, 1);
      EXPECT_EQ(apex, furthest);
    }
  }
}

TEST(NormalFan, OfFlatOrFewPointsThereIsNone) {
  EXPECT_FALSE(normal_fan(2, std::vector<double>{0, 0, 1, 1, 2, 2}));
  EXPECT_FALSE(normal_fan(3, std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

}  // namespace
}  // namespace sunder::polytope
