#include <sunder/base/error.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_contact.h>
#include <sunder/solid/round/round_round.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sunder::solid {
namespace {

Pose shifted(double x, double y, double z) { return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {x, y, z}); }

RoundVerdict verdict(const RoundBody& a, const RoundBody& b, const Pose& pose_b = Pose()) {
  return round_round(a, Pose(), b, pose_b).verdict();
}
std::optional<Contact> contact(const RoundBody& a, const RoundBody& b, const Pose& pose_b = Pose()) {
  return round_round_contact(a, Pose(), b, pose_b).contact;
}

ConvexPolyhedron cube(double half) {
  std::vector<Point3> corners;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      for (const double z : {-half, half}) corners.push_back({x, y, z});
    }
  }
  return ConvexPolyhedron(corners);
}

TEST(RoundBody, WhatIsRefused) {
  EXPECT_THROW((void)RoundBody::ball({0, 0, 0}, -1), Error);
  EXPECT_THROW((void)RoundBody::ball({0, 0, 0}, HUGE_VAL), Error);
  EXPECT_THROW((void)RoundBody::ball({std::nan(""), 0, 0}, 1), Error);
  EXPECT_THROW((void)RoundBody::cylinder({1, 2, 3}, {1, 2, 3}, 1), Error);
  EXPECT_THROW((void)RoundBody::cone({1, 2, 3}, {1, 2, 3}, 0), Error);
  EXPECT_THROW((void)RoundBody::ellipsoid({0, 0, 0}, {1, 0, 1}), Error);
  EXPECT_EQ(RoundBody::cylinder({0, 0, 0}, {0, 0, 1}, 0).kind(), RoundKind::hull);
}

TEST(RoundBody, PosesThatScale) {
  const Pose twice = Pose::from_matrix({2, 0, 0, 0, 2, 0, 0, 0, 2}, {0, 0, 0});
  const Pose sheared = Pose::from_matrix({1, 0.001, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0});
  for (const Pose& pose : {twice, sheared}) {
    EXPECT_THROW(require_rigid(RoundBody::ball({0, 0, 0}, 1), pose), Error);
    EXPECT_THROW(require_rigid(RoundBody::cylinder({0, 0, 0}, {0, 0, 1}, 1), pose), Error);
    EXPECT_NO_THROW(require_rigid(RoundBody::ellipsoid({0, 0, 0}, {1, 2, 3}), pose));
    EXPECT_NO_THROW(require_rigid(RoundBody::rounded(cube(1), 0), pose));
  }
  // The ellipsoid's own map, then the pose.
  EXPECT_EQ(
      round_round(RoundBody::ellipsoid({1, 0, 0}, {1, 2, 3}), twice, RoundBody::ball({5, 0, 0}, 1), Pose()).verdict(),
      RoundVerdict::meet);
  EXPECT_EQ(
      round_round(RoundBody::ellipsoid({1, 0, 0}, {1, 2, 3}), twice, RoundBody::ball({6, 0, 0}, 1), Pose()).verdict(),
      RoundVerdict::apart);
}

TEST(RoundRound, HullsToTheLastBit) {
  const RoundBody a = RoundBody::ball({0, 0, 0}, 2);
  EXPECT_EQ(verdict(a, RoundBody::ball({3, 4, 0}, 3)), RoundVerdict::meet);
  EXPECT_EQ(verdict(a, RoundBody::ball({3, 4, 0}, std::nextafter(3, 0))), RoundVerdict::apart);
  EXPECT_EQ(contact(a, RoundBody::ball({3, 4, 0}, 3)), Contact::touching);
  EXPECT_EQ(contact(a, RoundBody::ball({3, 4, 0}, std::nextafter(3, 4))), Contact::overlapping);
  EXPECT_EQ(contact(a, RoundBody::ball({3, 4, 0}, 2)), Contact::none);
  // The sum of the radii is no double: 1 + 2^-60.
  EXPECT_EQ(verdict(RoundBody::ball({0, 0, 0}, 1), RoundBody::ball({1, 0, 0}, 0x1p-60)), RoundVerdict::meet);
  EXPECT_EQ(contact(RoundBody::ball({0, 0, 0}, 1), RoundBody::ball({1, 0, 0}, 0x1p-60)), Contact::overlapping);
  EXPECT_EQ(contact(RoundBody::ball({0, 0, 0}, 1), RoundBody::ball({1, 0, 0}, 0)), Contact::touching);
}

TEST(RoundRound, EachKindOnABox) {
  const RoundBody box = RoundBody::rounded(cube(1), 0);
  const double up = std::nextafter(1, 2);
  for (const RoundBody& body : {RoundBody::ball({0, 0, 1}, 1), RoundBody::capsule({-5, 0, 1}, {5, 0, 1}, 1),
                                RoundBody::rounded(cube(1), 1), RoundBody::cylinder({-3, 0, 1}, {3, 0, 1}, 1),
                                RoundBody::cylinder({0, 0, 0}, {0, 0, 3}, 2), RoundBody::cone({0, 0, 3}, {0, 0, 0}, 2),
                                RoundBody::cone({0, 0, 0}, {0, 0, 2}, 3), RoundBody::ellipsoid({0, 0, 2}, {1, 3, 2})}) {
    const double off = body.kind() == RoundKind::hull && body.core().dimension() == 3 ? 2 : 0;
    EXPECT_EQ(contact(box, body, shifted(0, 0, 1 + off)), Contact::touching);
    EXPECT_EQ(contact(box, body, shifted(0, 0, 0.5 + off)), Contact::overlapping);
    EXPECT_EQ(verdict(box, body, shifted(0, 0, off + (off > 0 ? std::nextafter(1, 2) : up) + 0x1p-50)),
              RoundVerdict::apart);
  }
}

TEST(RoundRound, AFacetThatOnlyTheAxisPierces) {
  // A large triangle across a cone, and across its disc.
  const ConvexPolyhedron sheet(std::vector<Point3>{{-100, -100, 1}, {100, -100, 1}, {0, 100, 1}});
  const RoundBody cone = RoundBody::cone({0, 0, 0}, {0, 0, 4}, 2);
  EXPECT_EQ(verdict(cone, RoundBody::rounded(sheet, 0)), RoundVerdict::meet);
  const ConvexPolyhedron wall(std::vector<Point3>{{1.5, -100, -100}, {1.5, 100, -100}, {1.5, 0, 100}});
  EXPECT_EQ(verdict(cone, RoundBody::rounded(wall, 0)), RoundVerdict::meet);
  EXPECT_EQ(verdict(cone, RoundBody::rounded(wall, 0), shifted(0.5, 0, 0)), RoundVerdict::meet);
  EXPECT_EQ(verdict(cone, RoundBody::rounded(wall, 0), shifted(0.5 + 0x1p-40, 0, 0)), RoundVerdict::apart);
}

TEST(RoundClearance, ToTheLastBit) {
  const RoundBody a = RoundBody::ball({0, 0, 0}, 1), b = RoundBody::ball({3, 4, 0}, 2);
  EXPECT_TRUE(round_clearance(a, Pose(), b, Pose(), 2).kept);
  EXPECT_TRUE(round_clearance(a, Pose(), b, Pose(), std::nextafter(2, 0)).kept);
  const RoundClearance broken = round_clearance(a, Pose(), b, Pose(), std::nextafter(2, 3));
  EXPECT_FALSE(broken.kept);
  EXPECT_LE(broken.distance.low, 2);
  EXPECT_GE(broken.distance.high, 2);
  EXPECT_FALSE(round_clearance(a, Pose(), RoundBody::ball({1, 0, 0}, 1), Pose(), 1e-300).kept);
}

}  // namespace
}  // namespace sunder::solid
