#include <sunder/polytope/object/exact_matrix_internal.h>
#include <sunder/polytope/object/pose.h>

#include <sunder/base/random.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace sunder::polytope {
namespace {

TEST(PolytopePose, TheInverseIsExact) {
  const int cases = tests::scaled_count(500, 100);
  Random random(tests::chosen_seed(20261126));
  int singular = 0;
  for (int i = 0; i < cases; ++i) {
    const std::size_t d = 2 + random.below(5);
    std::vector<double> matrix(d * d);
    const bool small = random.below(2) == 0;
    for (double& x : matrix) {
      x = small ? static_cast<double>(random.between(-1, 1))
                : random.uniform(-1, 1) * random.log_uniform(1e-200, 1e200);
    }
    const auto inverse = exact_inverse(d, matrix);
    if (!inverse) {
      ++singular;
      EXPECT_TRUE(small);
      continue;
    }
    EXPECT_EQ(inverse->denominator.sign(), Sign::positive);
    for (std::size_t r = 0; r < d; ++r) {
      for (std::size_t c = 0; c < d; ++c) {
        Dyadic sum;
        for (std::size_t k = 0; k < d; ++k) sum = sum + Dyadic(matrix[r * d + k]) * inverse->numbers[k * d + c];
        EXPECT_TRUE(sum == (r == c ? inverse->denominator : Dyadic()));
      }
    }
  }
  EXPECT_GT(singular, cases / 50);
}

TEST(PolytopePose, RefusesWhatIsNone) {
  const std::vector<double> moved{1, 2}, swap{0, 1, 1, 0};
  EXPECT_FALSE(Pose::from_matrix(2, swap, moved).is_identity());
  EXPECT_TRUE(Pose::from_matrix(2, std::vector<double>{1, 0, 0, 1}, std::vector<double>{0, 0}).is_identity());
  EXPECT_THROW(Pose::from_matrix(2, std::vector<double>{1, 2, 2, 4}, moved), Error);
  EXPECT_THROW(Pose::from_matrix(2, std::vector<double>{0, 0, 0, 0}, moved), Error);
  EXPECT_THROW(Pose::from_matrix(3, swap, moved), Error);
  EXPECT_THROW(Pose::from_matrix(1, std::vector<double>{1}, std::vector<double>{1}), Error);
  EXPECT_THROW(Pose::from_matrix(2, swap, std::vector<double>{1, std::numeric_limits<double>::infinity()}), Error);
}

}  // namespace
}  // namespace sunder::polytope
