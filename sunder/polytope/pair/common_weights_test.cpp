#include <sunder/base/random.h>
#include <sunder/polytope/pair/common_weights.h>
#include <sunder/polytope/pair/null_vector_internal.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace sunder::polytope {
namespace {

// Of integers small enough for int64, and of numbers of very different sizes.
TEST(NullVector, IsARelation) {
  Random random(tests::chosen_seed(20261128));
  int found = 0, lower = 0;
  const int count = tests::scaled_count(2000, 200);
  for (int round = 0; round < count; ++round) {
    const std::size_t d = 2 + random.below(5), n = 1 + random.below(d + 1);
    std::vector<ExactVector> vectors(n, ExactVector(d));
    for (ExactVector& v : vectors) {
      for (Dyadic& x : v) {
        const double size = round % 3 == 0 ? std::ldexp(1.0, static_cast<int>(random.between(-900, 900))) : 1;
        x = Dyadic(static_cast<double>(random.between(-3, 3)) * size);
      }
    }
    if (n > 1 && n <= d) {  // dependent by construction
      vectors[n - 1] = ExactVector(d);
      for (std::size_t k = 0; k + 1 < n; ++k) {
        const Dyadic by = static_cast<double>(random.between(-2, 2));
        for (std::size_t c = 0; c < d; ++c) vectors[n - 1][c] = vectors[n - 1][c] + by * vectors[k][c];
      }
    }
    const auto numbers = null_vector(vectors);
    if (!numbers) continue;
    ++found;
    lower += n <= d;
    EXPECT_GE((*numbers)[n - 1], 0);
    EXPECT_TRUE(std::any_of(numbers->begin(), numbers->end(), [](const Integer& x) { return x != 0; }));
    for (std::size_t c = 0; c < d; ++c) {
      Dyadic sum;
      for (std::size_t k = 0; k < n; ++k) sum = sum + dyadic_of((*numbers)[k], 0) * vectors[k][c];
      EXPECT_EQ(sum.sign(), Sign::zero);
    }
  }
  EXPECT_GT(found, count / 4);
  EXPECT_GT(lower, count / 8);
  EXPECT_FALSE(null_vector(std::vector<ExactVector>{{1.0, 0.0}, {1.0, 0x1p-1074}}));
}

std::vector<std::uint32_t> all_of(const Polytope& body) {
  std::vector<std::uint32_t> rows(body.size());
  std::iota(rows.begin(), rows.end(), 0u);
  return rows;
}

// Two simplices, often touching or flat: where weights are found, they are a proof; where the bodies meet, they mostly
// are.
TEST(CommonWeights, AreAProof) {
  const int count = tests::scaled_count(2000, 200);
  Random random(tests::chosen_seed(20261128));
  int meets = 0, found = 0;
  for (int round = 0; round < count; ++round) {
    const std::size_t d = 2 + random.below(5);
    const auto simplex = [&] {
      std::vector<double> rows(d * (1 + random.below(d + 1)));
      for (double& x : rows) x = static_cast<double>(random.between(-2, 2));
      return Polytope::from_points(d, rows);
    };
    const Polytope a = simplex(), b = simplex();
    Pose there(d);
    if (round % 2 == 0) there = Pose::from_matrix(d, Pose(d).linear(), std::vector<double>(d, random.uniform(-1, 1)));
    const std::vector<std::uint32_t> rows_a = all_of(a), rows_b = all_of(b);
    const auto common = common_point_by_determinants(a, there, b, there, {rows_a, rows_b});
    const bool meet = polytope_polytope_by_scan(a, there, b, there).meet();
    meets += meet;
    if (!common) continue;
    ++found;
    ASSERT_TRUE(meet);
    EXPECT_TRUE(check(a, there, b, there, Verdict::meet, *common));
    EXPECT_LE(common->of_a.parts.size() + common->of_b.parts.size(), d + 2);
  }
  EXPECT_GT(meets, count / 20);
  EXPECT_GT(found, meets / 2);
}

// Bodies with the same centre meet where the search's simplex is of few points.
TEST(CommonWeights, ProveWhatIsOnALowFace) {
  for (std::size_t d = 2; d <= 6; ++d) {
    std::vector<double> rows;
    for (std::size_t k = 0; k < std::size_t{1} << d; ++k) {
      for (std::size_t c = 0; c < d; ++c) rows.push_back((k >> c) & 1 ? 1.0 : -1.0);
    }
    const Polytope cube = Polytope::from_points(d, rows);
    const Pose here(d);
    const PolytopeAnswer answer = polytope_polytope(cube, here, cube, here);
    EXPECT_TRUE(answer.meet());
    EXPECT_EQ(answer.decided_by, DecidedBy::evidence);
    EXPECT_TRUE(check(cube, here, cube, here, Verdict::meet, exact_evidence(cube, here, cube, here, answer)));
  }
}

}  // namespace
}  // namespace sunder::polytope
