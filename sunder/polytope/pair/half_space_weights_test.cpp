#include <sunder/polytope/pair/half_space_weights.h>

#include <gtest/gtest.h>

#include <array>

namespace sunder::polytope {
namespace {

const Polytope two_points = Polytope::from_points(2, {0, 0, 1, 0}), left = Polytope::from_half_spaces(2, {1, 0, 0.25}),
               beyond = Polytope::from_half_spaces(2, {1, 0, -0.5});
const Pose in_place(2);

std::optional<ExactDecision> met(const Polytope& half_spaces, double first, double second) {
  Placed a(half_spaces, in_place), b(two_points, in_place);
  Cost cost;
  return met_by_weights(a, b, std::array{Weights::Part{0, first}, Weights::Part{1, second}}, cost);
}

TEST(HalfSpaceWeights, OfPointsMakeAPointInside) {
  EXPECT_TRUE(met(left, 1, 0).has_value());
  EXPECT_TRUE(met(left, 3, 1).has_value());  // on the boundary
  EXPECT_FALSE(met(left, 3, 1 + 0x1p-50).has_value());
  EXPECT_FALSE(met(left, 0, 0).has_value());
  EXPECT_EQ(met(left, 3, 1)->verdict, Verdict::meet);
}

// Twice the first point less the second is beyond the hull, and in that half-space.
TEST(HalfSpaceWeights, NegativeOnesAreNoProof) {
  EXPECT_FALSE(met(beyond, 2, -1).has_value());
  EXPECT_FALSE(met(beyond, -2, 1).has_value());
}

TEST(HalfSpaceWeights, OfHalfSpacesPartThePoints) {
  Cost cost;
  Placed far(beyond, in_place), near(left, in_place), b(two_points, in_place);
  const auto parted = parted_by_weights(far, b, std::array{Weights::Part{0, 1.0}}, cost);
  ASSERT_TRUE(parted.has_value());
  EXPECT_EQ(parted->verdict, Verdict::apart);
  EXPECT_FALSE(parted_by_weights(near, b, std::array{Weights::Part{0, 1.0}}, cost).has_value());
}

}  // namespace
}  // namespace sunder::polytope
