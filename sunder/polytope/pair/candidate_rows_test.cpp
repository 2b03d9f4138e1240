#include <sunder/polytope/pair/candidate_rows.h>

#include <sunder/base/random.h>
#include <sunder/polytope/object/polytope.h>

#include <gtest/gtest.h>

#include <vector>

namespace sunder::polytope {
namespace {

Polytope random_points(Random& random, std::size_t count) {
  std::vector<double> rows(count * 3);
  for (double& x : rows) x = random.uniform(-1, 1);
  return Polytope::from_points(3, rows);
}

TEST(CandidateRows, GoFromASampleToAllAndToTheShortlist) {
  Random random(20261127);
  const Polytope body = random_points(random, 1000);
  const ColumnNumbers direction{1, 0.5, -0.25}, near{1, 0.5, -0.26};
  const FurthestPoint furthest = furthest_along(body.columns(), direction);
  CandidateRows candidates(body);
  Cost cost;
  EXPECT_FALSE(candidates.are_all());
  EXPECT_LE(candidates.furthest(direction, cost).product, furthest.product);
  const auto of_sample = cost.probes;
  EXPECT_GT(of_sample, 30u);
  EXPECT_LT(of_sample, 260u);
  candidates.widen();
  EXPECT_TRUE(candidates.are_all());
  EXPECT_EQ(candidates.furthest(direction, cost).index, furthest.index);
  EXPECT_EQ(cost.probes, of_sample + 1000);
  candidates.narrow();
  EXPECT_FALSE(candidates.are_all());
  EXPECT_EQ(candidates.furthest(direction, cost).index, furthest.index);
  EXPECT_EQ(candidates.furthest(near, cost).index, furthest_along(body.columns(), near).index);
  EXPECT_LE(cost.probes, of_sample + 1000 + 2 * Shortlist::most);
  // Along the opposite there is no telling; all rows do.
  const ColumnNumbers opposite{-1, -0.5, 0.25};
  const FurthestPoint other = furthest_along(body.columns(), opposite);
  EXPECT_LT(candidates.furthest(opposite, cost).product, other.product);
  candidates.widen();
  EXPECT_EQ(candidates.furthest(opposite, cost).index, other.index);
}

TEST(CandidateRows, OfFewRowsAreAllOfThem) {
  Random random(20261127);
  const Polytope body = random_points(random, 100);
  CandidateRows candidates(body);
  EXPECT_TRUE(candidates.are_all());
  Cost cost;
  candidates.furthest({1, 1, 1}, cost);
  candidates.narrow();
  EXPECT_TRUE(candidates.are_all());
  EXPECT_EQ(candidates.furthest({-1, -1, -1}, cost).index, furthest_along(body.columns(), {-1, -1, -1}).index);
  EXPECT_EQ(cost.probes, 200u);
}

TEST(CandidateRows, AtBothGoOnTogether) {
  Random random(20261127);
  const Polytope few = random_points(random, 10), many = random_points(random, 5000);
  CandidateRowsOfBoth candidates(few, many);
  EXPECT_FALSE(candidates.are_all());
  candidates.narrow();  // nothing, as not all were looked at
  EXPECT_TRUE(candidates.widen());
  EXPECT_TRUE(candidates.are_all());
  EXPECT_FALSE(candidates.widen());
  Cost cost;
  candidates.b.furthest({0, 1, 0}, cost);
  candidates.narrow();
  EXPECT_TRUE(candidates.a.are_all());
  EXPECT_FALSE(candidates.b.are_all());
  EXPECT_TRUE(candidates.widen());
}

}  // namespace
}  // namespace sunder::polytope
