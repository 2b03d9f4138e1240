#include <sunder/solid/round/round_round_sweep.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

using tests::shift;

const RoundBody unit_ball = RoundBody::ball({0, 0, 0}, 1);

RoundBody box(double half) {
  std::vector<Point3> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back({(k & 1) != 0 ? half : -half, (k & 2) != 0 ? half : -half, (k & 4) != 0 ? half : -half});
  }
  return ConvexPolyhedron(corners);
}

Verdict past(const RoundBody& a, const RoundBody& b, double aside) {
  return round_round_sweep(a, Translation(Pose()), b, {shift(-5, aside, 0), shift(5, aside, 0)}).verdict();
}

TEST(RoundRoundSweep, BallsThatTouchOnTheWay) {
  const Translation rests{Pose()}, goes(shift(-5, 2, 0), shift(5, 2, 0));
  const SweepAnswer answer = round_round_sweep(unit_ball, rests, unit_ball, goes);
  ASSERT_TRUE(answer.meet());
  const SweepContact& contact = *std::get<ContactOnTheWay>(answer.evidence).contact;
  EXPECT_EQ(contact.time.nearest(), 0.5);
  EXPECT_EQ(nearest(contact.point.at).y, 1);
  const RoundFirstContact first = round_round_first_contact(unit_ball, rests, unit_ball, goes, answer);
  EXPECT_LE(first.time.low, 0.5);
  EXPECT_EQ(first.time.high, 0.5);
  EXPECT_EQ(past(unit_ball, unit_ball, std::nextafter(2.0, 3.0)), Verdict::apart);
  // As far as sqrt(3^2 + 4^2), across a way that is not along an axis.
  const Translation slanted(shift(3 - 40, 4 + 30, 0), shift(3 + 20, 4 - 15, 0));
  const RoundBody large = RoundBody::ball({0, 0, 0}, 4), larger = RoundBody::ball({0, 0, 0}, std::nextafter(4.0, 3.0));
  EXPECT_TRUE(round_round_sweep(large, rests, unit_ball, slanted).meet());
  EXPECT_EQ(round_round_sweep(larger, rests, unit_ball, slanted).verdict(), Verdict::apart);
}

TEST(RoundRoundSweep, EdgesThatTouchRoundedCorners) {
  const RoundBody rounded = RoundBody::rounded(box(1).core(), 0.5);
  for (const auto& [body, reach] : {std::pair(box(2), 3.5), std::pair(unit_ball, 2.5), std::pair(rounded, 3.0)}) {
    EXPECT_EQ(past(rounded, body, reach), Verdict::meet);
    EXPECT_EQ(past(rounded, body, std::nextafter(reach, 9.0)), Verdict::apart);
    EXPECT_EQ(past(body, rounded, reach), Verdict::meet);
    EXPECT_EQ(past(body, rounded, std::nextafter(reach, 9.0)), Verdict::apart);
  }
}

TEST(RoundRoundSweep, CurvedBodiesInNumbersThatPeopleGive) {
  const RoundBody cylinder = RoundBody::cylinder({0, 0, -1}, {0, 0, 1}, 1);
  const RoundBody ellipsoid = RoundBody::ellipsoid({0, 0, 0}, {3, 2, 1});
  const RoundBody cone = RoundBody::cone({0, 0, -1}, {0, 0, 1}, 2);
  EXPECT_EQ(past(cylinder, box(1), 2), Verdict::meet);
  EXPECT_EQ(past(cylinder, box(1), 2.0000001), Verdict::apart);
  EXPECT_EQ(past(ellipsoid, box(1), 3), Verdict::meet);
  EXPECT_EQ(past(ellipsoid, unit_ball, 3), Verdict::meet);
  EXPECT_EQ(past(ellipsoid, unit_ball, 3.0000001), Verdict::apart);
  EXPECT_EQ(past(cone, cylinder, 2.9), Verdict::meet);
  EXPECT_EQ(past(cone, cylinder, 3.0000001), Verdict::apart);
}

TEST(RoundRoundSweep, WhatMeetsAtAnEnd) {
  const Translation leaves(shift(2, 0, 0), shift(7, 0, 0)), comes(shift(7, 0, 0), shift(2, 0, 0)), rests{Pose()};
  const SweepAnswer first = round_round_sweep(unit_ball, rests, unit_ball, leaves);
  ASSERT_TRUE(first.meet());
  EXPECT_EQ(round_round_first_contact(unit_ball, rests, unit_ball, leaves, first).time.high, 0);
  const SweepAnswer last = round_round_sweep(unit_ball, rests, unit_ball, comes);
  ASSERT_TRUE(last.meet());
  const RoundFirstContact contact = round_round_first_contact(unit_ball, rests, unit_ball, comes, last);
  EXPECT_EQ(contact.time.high, 1);
  EXPECT_GE(contact.time.low, 1 - 0x1p-40);
  EXPECT_TRUE(round_round_sweep(unit_ball, rests, unit_ball, Translation(shift(2, 0, 0))).meet());
  EXPECT_EQ(round_round_sweep(unit_ball, rests, unit_ball, Translation(shift(2.5, 0, 0))).verdict(), Verdict::apart);
}

// The first time is that of two quadratic roots: enclosed, and narrowly.
TEST(RoundRoundSweep, FirstTimesAreEnclosed) {
  const Translation rests{Pose()};
  for (const double aside : {0.0, 0.3, 1.0, 1.9, 1.999, 1.9999999}) {
    const Translation goes(shift(-5, aside, 0), shift(5, aside, 0));
    const SweepAnswer answer = round_round_sweep(unit_ball, rests, unit_ball, goes);
    ASSERT_TRUE(answer.meet());
    const Interval time = round_round_first_contact(unit_ball, rests, unit_ball, goes, answer).time;
    const double expected = (5 - std::sqrt((2 - aside) * (2 + aside))) / 10;
    EXPECT_LE(time.low, expected + 0x1p-50) << aside;
    EXPECT_GE(time.high, expected - 0x1p-50) << aside;
    EXPECT_LE(time.high - time.low, aside < 1.99 ? 0x1p-40 : 0x1p-24) << aside;
  }
}

// Where cores meet, too: the point is the cores'.
TEST(RoundRoundSweep, NeedlesThatCross) {
  const RoundBody a = RoundBody::capsule({0, 0, -1}, {0, 0, 1}, 0x1p-600);
  const RoundBody b = RoundBody::capsule({0, -1, 0}, {0, 1, 0}, 0);
  const double third = 1.0 / 3;
  EXPECT_TRUE(round_round_sweep(a, Translation(Pose()), b, {shift(-third, 0, third), shift(1, 0, 0.1)}).meet());
  EXPECT_EQ(round_round_sweep(a, Translation(Pose()), b, {shift(-third, 0, third), shift(1, 0, 8)}).verdict(),
            Verdict::apart);
}

}  // namespace
}  // namespace sunder::solid
