#include <sunder/predicate/disc/round_shape.h>

#include <gtest/gtest.h>

#include <cmath>

namespace sunder {
namespace {

const Affine3 here{};

RoundShape ball(const Point3& centre, double radius) { return {RoundKind::hull, {centre}, &here, radius}; }
RoundShape cylinder(const Point3& base, const Point3& top, double radius) {
  return {RoundKind::cylinder, {base, top}, &here, radius};
}
RoundShape cone(const Point3& base, const Point3& apex, double radius) {
  return {RoundKind::cone, {base, apex}, &here, radius};
}
WeightedPoint at(const Point3& p) { return {1, {Posed3{p, &here, false}}, {1}}; }
Sign gap(const Point3& d, const RoundShape& a, const RoundShape& b) { return gap_sign(WorldDirection(d), a, b); }

TEST(RoundShape, BallsAlongTheWayBetweenThem) {
  // 3-4-5: the distance is 5.
  EXPECT_EQ(gap({3, 4, 0}, ball({0, 0, 0}, 2), ball({3, 4, 0}, 3)), Sign::zero);
  EXPECT_EQ(gap({3, 4, 0}, ball({0, 0, 0}, 2), ball({3, 4, 0}, std::nextafter(3, 0))), Sign::positive);
  EXPECT_EQ(gap({3, 4, 0}, ball({0, 0, 0}, 2), ball({3, 4, 0}, std::nextafter(3, 4))), Sign::negative);
  EXPECT_EQ(gap({-3, -4, 0}, ball({0, 0, 0}, 2), ball({3, 4, 0}, 2)), Sign::negative);
  EXPECT_EQ(gap({3, 4, 0}, ball({0, 0, 0}, 5), ball({3, 4, 0}, 5e-324)), Sign::negative);
}

TEST(RoundShape, EveryEndCounts) {
  const RoundShape far = ball({10, 0, 0}, 1);
  EXPECT_EQ(gap({1, 0, 0}, cylinder({0, 0, 0}, {0, 0, 2}, 9), far), Sign::zero);
  EXPECT_EQ(gap({1, 0, 0}, cylinder({-5, 0, 0}, {9, 0, 0}, 100), far), Sign::zero);
  EXPECT_EQ(gap({1, 0, 0}, cylinder({9, 0, 0}, {-5, 0, 0}, 100), far), Sign::zero);
  EXPECT_EQ(gap({1, 0, 0}, cone({0, 0, 0}, {0, 0, 2}, 9), far), Sign::zero);
  EXPECT_EQ(gap({1, 0, 0}, cone({0, 0, 0}, {9, 0, 0}, 100), far), Sign::zero);
  EXPECT_EQ(gap({1, 0, 0}, cone({0, 0, 0}, {9.5, 0, 0}, 1), far), Sign::negative);
  // Along (3, 0, 4) the cone's rim reaches 2 * 3, its apex 4 * 2.5, and the ball back to 25 - 15.
  EXPECT_EQ(gap({3, 0, 4}, cone({0, 0, 0}, {0, 0, 2.5}, 2), ball({3, 0, 4}, 3)), Sign::zero);
}

TEST(RoundShape, AnEllipsoidReachesByItsMap) {
  const Affine3 map{{2, 0, 0, 0, 1, 0, 0, 0, 0.5}, {1, 0, 0}};
  const RoundShape e{RoundKind::ellipsoid, {}, &map, 1};
  EXPECT_EQ(gap({1, 0, 0}, e, ball({5, 0, 0}, 2)), Sign::zero);
  EXPECT_EQ(gap({0, 0, 1}, e, ball({1, 0, 1}, 0.5)), Sign::zero);
  EXPECT_EQ(gap({0, 1, 0}, e, ball({1, 2, 0}, 1.0625)), Sign::negative);
}

TEST(RoundShape, SidesOfPoints) {
  const RoundShape c = cylinder({0, 0, 0}, {0, 0, 4}, 5);
  EXPECT_EQ(side_of(c, at({3, 3, 2})), Sign::positive);
  EXPECT_EQ(side_of(c, at({3, 4, 2})), Sign::zero);
  EXPECT_EQ(side_of(c, at({3, std::nextafter(4, 5), 2})), Sign::negative);
  EXPECT_EQ(side_of(c, at({1, 1, 4})), Sign::zero);
  EXPECT_EQ(side_of(c, at({1, 1, -5e-324})), Sign::negative);
  const RoundShape k = cone({0, 0, 0}, {0, 0, 4}, 2);
  EXPECT_EQ(side_of(k, at({0, 0, 4})), Sign::zero);
  EXPECT_EQ(side_of(k, at({1, 0, 2})), Sign::zero);
  EXPECT_EQ(side_of(k, at({0.5, 0, 2})), Sign::positive);
  EXPECT_EQ(side_of(k, at({1, 0.0625, 2})), Sign::negative);
  EXPECT_EQ(side_of(k, at({0, 0, 5})), Sign::negative);  // of the other half of the double cone
  const Affine3 map{{0, 2, 0, 1, 0, 0, 0, 0, -0.5}, {1, 0, 0}};
  const RoundShape e{RoundKind::ellipsoid, {}, &map, 1};
  EXPECT_EQ(side_of(e, at({3, 0, 0})), Sign::zero);
  EXPECT_EQ(side_of(e, at({1, 1, 0})), Sign::zero);
  EXPECT_EQ(side_of(e, at({1, 0, 0.25})), Sign::positive);
  EXPECT_EQ(side_of(e, at({1, 0, -0.75})), Sign::negative);
}

TEST(RoundShape, PointsAsCombinations) {
  WeightedPoint third{2, {Posed3{{0, 0, 0}, &here, false}, Posed3{{3, 0, 0}, &here, false}}, {2, 1}};
  const ExactPoint3 x = exact_point(third);
  EXPECT_EQ(nearest(x).x, 1);
  EXPECT_EQ(nearness(third, 0, at({1, 0, 0}), 0), Sign::zero);
  EXPECT_EQ(nearness(third, 1, at({4, 0, 0}), 2), Sign::zero);
  EXPECT_EQ(nearness(third, 1, at({4, 0, 0}), std::nextafter(2, 0)), Sign::negative);
  EXPECT_EQ(nearness(third, 1, at({4, 0, 5e-324}), 2), Sign::negative);
  EXPECT_EQ(nearness(third, 1e300, at({4, 0, 0}), 2), Sign::positive);
}

TEST(RoundShape, ThreeNumbers) {
  EXPECT_EQ(gap_sign(Dyadic(5.0), Dyadic(4.0), Dyadic(9.0)), Sign::zero);
  EXPECT_EQ(gap_sign(Dyadic(5.0), Dyadic(4.0), Dyadic(8.0)), Sign::positive);
  EXPECT_EQ(gap_sign(Dyadic(3.0), Dyadic(4.0), Dyadic(9.0)), Sign::negative);
  EXPECT_EQ(gap_sign(Dyadic(-6.0), Dyadic(4.0), Dyadic(9.0)), Sign::negative);
  EXPECT_EQ(gap_sign(Dyadic(0.0), Dyadic(0.0), Dyadic(0.0)), Sign::zero);
  EXPECT_EQ(gap_sign(Dyadic(0.0), Dyadic(0.0), Dyadic(1.0)), Sign::negative);
}

}  // namespace
}  // namespace sunder
