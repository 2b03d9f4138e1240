#include <sunder/base/random.h>
#include <sunder/polytope/pair/facet_normal.h>
#include <sunder/polytope/pair/orthogonal_complement.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunder::polytope {
namespace {

// Integers: a body where x1 <= 0, or x1 >= gap, of which the first points lie in a face of so many dimensions there,
// around the origin, each with its opposite; x1 stands for another combination of what is written.
Polytope with_face(Random& random, std::size_t d, std::size_t face, double side, double gap, std::size_t count = 60) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> x(d);
    for (double& number : x) {
      number = static_cast<double>(random.between(-(std::int64_t{1} << 45), std::int64_t{1} << 45));
    }
    x[0] = side * std::fabs(x[0]);
    if (k < 8) {
      x[0] = 0;
      for (std::size_t c = face + 1; c < d; ++c) x[c] = 0;
      if (k % 2 == 1) {
        for (std::size_t c = 1; c < d; ++c) x[c] = -rows[(k - 1) * d + c];
      }
    }
    if (side > 0) x[0] += gap;
    for (std::size_t c = 1; c < d; ++c) x[0] += static_cast<double>(2 * c + 1) * x[c];
    rows.insert(rows.end(), x.begin(), x.end());
  }
  // Of many points, no sample has those of the face.
  if (count > 256) std::rotate(rows.begin(), rows.end() - static_cast<std::ptrdiff_t>(32 * d), rows.end());
  return Polytope::from_points(d, rows);
}

// Faces of any dimension that touch, or that a last bit is between: a proposal holds, so the simplex method has nothing
// to do.
TEST(FacetNormal, PartsFacesALastBitApart) {
  Random random(tests::chosen_seed(20261127));
  const int count = tests::scaled_count(40, 10);
  for (std::size_t d = 2; d <= 6; ++d) {
    int finished = 0, pairs = 0;
    for (std::size_t face = 0; face < d; ++face) {
      for (int i = 0; i < count; ++i) {
        const Polytope a = with_face(random, d, face, -1, 0), b = with_face(random, d, d - 1 - face / 2, 1, 1);
        const Pose here(d);
        const PolytopeAnswer answer = polytope_polytope(a, here, b, here);
        EXPECT_FALSE(answer.meet());
        EXPECT_TRUE(check(a, here, b, here, answer.verdict(), exact_evidence(a, here, b, here, answer)));
        finished += answer.decided_by == DecidedBy::finishing;
        ++pairs;
      }
    }
    RecordProperty("finished_" + std::to_string(d), finished);
    EXPECT_LE(finished, pairs / 20 + 1) << "of " << pairs << " where d = " << d;
  }
}

// The search for what is further than a flat looks at all points before it ends.
TEST(FacetNormal, PartsFacesOfManyPoints) {
  Random random(tests::chosen_seed(20261128));
  const int count = tests::scaled_count(20, 5);
  int finished = 0, pairs = 0;
  for (std::size_t d = 2; d <= 6; ++d) {
    for (std::size_t face = 0; face < d; ++face) {
      for (int i = 0; i < count; ++i) {
        const Polytope a = with_face(random, d, face, -1, 0, 600), b = with_face(random, d, d - 1 - face, 1, 1, 600);
        const Pose here(d);
        const PolytopeAnswer answer = polytope_polytope(a, here, b, here);
        EXPECT_FALSE(answer.meet());
        EXPECT_TRUE(check(a, here, b, here, answer.verdict(), exact_evidence(a, here, b, here, answer)));
        finished += answer.decided_by == DecidedBy::finishing;
        ++pairs;
      }
    }
  }
  RecordProperty("finished", finished);
  EXPECT_LE(finished, pairs / 8) << "of " << pairs;
}

// The normal is that of the points that matter exactly, whatever completes them: an edge against an edge.
TEST(FacetNormal, OfTwoEdgesIsOrthogonalToBoth) {
  const Polytope a = Polytope::from_points(4, {-1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 2, -3}),
                 b = Polytope::from_points(4, {0, -1, 0, 0x1p-60, 0, 1, 0, 0x1p-60, 1, 0, 1, 4});
  const Pose here(4);
  const PolytopeAnswer answer = polytope_polytope(a, here, b, here);
  EXPECT_FALSE(answer.meet());
  EXPECT_EQ(answer.decided_by, DecidedBy::evidence);
  const ExactEvidence evidence = exact_evidence(a, here, b, here, answer);
  EXPECT_TRUE(check(a, here, b, here, Verdict::apart, evidence));
  EXPECT_EQ(evidence.numbers[0].sign(), Sign::zero);
  EXPECT_EQ(evidence.numbers[1].sign(), Sign::zero);
}

// Vectors whose squares doubles can hold only just: what is taken out is so, and all stays finite.
TEST(FacetNormal, ComplementsOfVectorsThatNearlyOverflow) {
  Random random(tests::chosen_seed(20261127));
  int refused = 0, taken = 0;
  for (int round = 0; round < 40000; ++round) {
    const std::size_t n = 2 + random.below(6);
    OrthogonalComplement complement(n);
    ColumnNumbers first{}, last{};
    double square = 0;
    for (std::size_t c = 0; c < n; ++c) {
      first[c] = random.uniform(-1, 1);
      last[c] = static_cast<double>(random.between(-1, 1));
      square += last[c] * last[c];
    }
    if (square == 0) continue;
    const double length = std::sqrt(1.7976931348623157e308) * (round % 2 == 0 ? 1 : 0.6);
    for (double& x : last) x *= length / std::sqrt(square);
    ASSERT_TRUE(complement.take_out(first));
    const bool is_taken = complement.take_out(last);
    for (std::size_t k = 0; k < complement.dimension(); ++k) {
      double product = 0;
      for (std::size_t c = 0; c < n; ++c) {
        ASSERT_LE(std::fabs(complement.base(k)[c]), 1 + 0x1p-40) << round;
        product += complement.base(k)[c] * (last[c] / length);
      }
      ASSERT_TRUE(!is_taken || std::fabs(product) < 0x1p-40) << round;
    }
    ++(is_taken ? taken : refused);
  }
  EXPECT_GT(taken, 1000);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace sunder::polytope
