#include <sunder/base/random.h>
#include <sunder/number/dyadic.h>
#include <sunder/predicate/point/verified_inverse.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sunder {
namespace {

Dyadic size_of(const Dyadic& x) { return x.sign() == Sign::negative ? -x : x; }

// Against exact numbers: no row of I - R M' is more than the bound, for M' as far from M as its widths let it be.
TEST(VerifiedInverse, TheBoundHoldsAndIsOfUse) {
  Random random(tests::chosen_seed(20261206));
  const int count = tests::scaled_count(2000, 300);
  int tight = 0, of_no_use = 0;
  for (int round = 0; round < count; ++round) {
    const std::size_t n = 1 + random.below(7);
    std::vector<double> matrix(n * n), off(n * n), width(n), inverse(n * n);
    const bool nearly_singular = round % 4 == 0, has_widths = round % 2 == 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double scale = std::ldexp(1.0, static_cast<int>(random.between(-200, 200)));
      for (std::size_t j = 0; j < n; ++j) {
        matrix[i * n + j] = random.uniform(-1, 1) * scale;
        if (nearly_singular && i > 0) matrix[i * n + j] = matrix[j] * (1 + 0x1p-30 * random.uniform(-1, 1));
        if (has_widths) off[i * n + j] = matrix[i * n + j] * 0x1p-20 * random.uniform(-1, 1);
        width[i] += std::fabs(off[i * n + j]) * (1 + 0x1p-50);
      }
    }
    const double bound = verified_inverse(matrix, width, inverse);
    of_no_use += !(bound < 1);
    tight += bound < 0x1p-30;
    if (!std::isfinite(bound)) continue;
    for (std::size_t i = 0; i < n; ++i) {
      Dyadic sum;
      for (std::size_t j = 0; j < n; ++j) {
        Dyadic e = i == j ? 1.0 : 0.0;
        for (std::size_t k = 0; k < n; ++k) {
          // The worst of matrices within the widths: all that is off adds up.
          e = e - Dyadic(inverse[i * n + k]) * (Dyadic(matrix[k * n + j]) + Dyadic(off[k * n + j]));
        }
        sum = sum + size_of(e);
      }
      ASSERT_NE((Dyadic(bound) - sum).sign(), Sign::negative);
    }
  }
  EXPECT_GT(tight, count / 4);
  EXPECT_LT(of_no_use, count / 2);
}

TEST(VerifiedInverse, IsInfiniteWhereThereIsNone) {
  std::vector<double> inverse(4);
  const std::vector<double> no_width(2);
  EXPECT_TRUE(std::isinf(verified_inverse(std::vector<double>{1, 2, 2, 4}, no_width, inverse)));
  EXPECT_TRUE(std::isinf(verified_inverse(std::vector<double>{0, 0, 1, 1}, no_width, inverse)));
  EXPECT_TRUE(std::isinf(verified_inverse(std::vector<double>{1e308, 1e308, 1e308, -1e308}, no_width, inverse)));
  EXPECT_LT(verified_inverse(std::vector<double>{0, 2, 4, 0}, no_width, inverse), 0x1p-40);
  EXPECT_EQ(inverse, (std::vector<double>{0, 0.25, 0.5, 0}));
  EXPECT_GE(verified_inverse(std::vector<double>{1, 0, 0, 1}, std::vector<double>{0.5, 0.25}, inverse), 0.5);
}

}  // namespace
}  // namespace sunder
