#include <sunder/polytope/pair/looks.h>

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

TEST(Looks, GoFromASampleToAllAndToTheShortlist) {
  Random random(20261127);
  const Polytope body = random_points(random, 1000);
  const ColumnNumbers direction{1, 0.5, -0.25}, near{1, 0.5, -0.26};
  const FurthestPoint furthest = furthest_along(body.columns(), direction);
  Looks looks(body);
  Cost cost;
  EXPECT_FALSE(looks.are_all());
  EXPECT_LE(looks.furthest(direction, cost).product, furthest.product);
  const auto of_sample = cost.probes;
  EXPECT_GT(of_sample, 30u);
  EXPECT_LT(of_sample, 260u);
  looks.widen();
  EXPECT_TRUE(looks.are_all());
  EXPECT_EQ(looks.furthest(direction, cost).index, furthest.index);
  EXPECT_EQ(cost.probes, of_sample + 1000);
  looks.narrow();
  EXPECT_FALSE(looks.are_all());
  EXPECT_EQ(looks.furthest(direction, cost).index, furthest.index);
  EXPECT_EQ(looks.furthest(near, cost).index, furthest_along(body.columns(), near).index);
  EXPECT_LE(cost.probes, of_sample + 1000 + 2 * Shortlist::most);
  // Along the opposite there is no telling; all rows do.
  const ColumnNumbers opposite{-1, -0.5, 0.25};
  const FurthestPoint other = furthest_along(body.columns(), opposite);
  EXPECT_LT(looks.furthest(opposite, cost).product, other.product);
  looks.widen();
  EXPECT_EQ(looks.furthest(opposite, cost).index, other.index);
}

TEST(Looks, OfFewRowsAreAllOfThem) {
  Random random(20261127);
  const Polytope body = random_points(random, 100);
  Looks looks(body);
  EXPECT_TRUE(looks.are_all());
  Cost cost;
  looks.furthest({1, 1, 1}, cost);
  looks.narrow();
  EXPECT_TRUE(looks.are_all());
  EXPECT_EQ(looks.furthest({-1, -1, -1}, cost).index, furthest_along(body.columns(), {-1, -1, -1}).index);
  EXPECT_EQ(cost.probes, 200u);
}

TEST(Looks, AtBothGoOnTogether) {
  Random random(20261127);
  const Polytope few = random_points(random, 10), many = random_points(random, 5000);
  LooksAtBoth looks(few, many);
  EXPECT_FALSE(looks.are_all());
  looks.narrow();  // nothing, as not all were looked at
  EXPECT_TRUE(looks.widen());
  EXPECT_TRUE(looks.are_all());
  EXPECT_FALSE(looks.widen());
  Cost cost;
  looks.b.furthest({0, 1, 0}, cost);
  looks.narrow();
  EXPECT_TRUE(looks.a.are_all());
  EXPECT_FALSE(looks.b.are_all());
  EXPECT_TRUE(looks.widen());
}

}  // namespace
}  // namespace sunder::polytope
