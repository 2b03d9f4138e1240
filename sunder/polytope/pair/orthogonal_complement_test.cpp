#include <sunder/base/random.h>
#include <sunder/polytope/pair/orthogonal_complement.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace sunder::polytope {
namespace {

double product(const ColumnNumbers& u, const ColumnNumbers& v) {
  double sum = 0;
  for (std::size_t c = 0; c < u.size(); ++c) sum += u[c] * v[c];
  return sum;
}

TEST(OrthogonalComplement, IsOrthogonalToWhatWasTakenOut) {
  Random random(20261127);
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = 2 + random.below(6);
    OrthogonalComplement complement(n);
    std::array<ColumnNumbers, most_columns> taken{};
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t c = 0; c < n; ++c) taken[k][c] = static_cast<double>(random.between(-3, 3));
      if (!complement.take_out(taken[k])) taken[k] = {};  // depends on those before
      std::size_t rank = 0;
      for (std::size_t i = 0; i <= k; ++i) rank += product(taken[i], taken[i]) > 0 ? 1u : 0u;
      ASSERT_EQ(complement.dimension(), n - rank);
      for (std::size_t i = 0; i < complement.dimension(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          EXPECT_NEAR(product(complement.base(i), complement.base(j)), i == j ? 1 : 0, 1e-12);
        }
        for (std::size_t j = 0; j <= k; ++j) EXPECT_NEAR(product(complement.base(i), taken[j]), 0, 1e-12);
      }
    }
    ColumnNumbers v{};
    for (std::size_t c = 0; c < n; ++c) v[c] = random.uniform(-1, 1);
    const ColumnNumbers there = complement.coordinates(v), again = complement.coordinates(complement.vector(there));
    for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(there[k], again[k], 1e-12);
  }
}

TEST(OrthogonalComplement, OfDependentVectorsIsThatOfSome) {
  OrthogonalComplement complement(3);
  EXPECT_TRUE(complement.take_out({1, 2, 3}));
  EXPECT_FALSE(complement.take_out({2, 4, 6}));
  EXPECT_FALSE(complement.take_out({}));
  EXPECT_TRUE(complement.take_out({1, 2, 4}));
  EXPECT_FALSE(complement.take_out({0, 0, 1}));
  EXPECT_EQ(complement.dimension(), 1u);
}

}  // namespace
}  // namespace sunder::polytope
