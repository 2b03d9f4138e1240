#include <sunder/solid/round/round_depth.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sunder::solid {
namespace {

using tests::shift;

EnclosedDepth depth(const RoundBody& a, const RoundBody& b, const Pose& pose_b = Pose()) {
  return std::get<EnclosedDepth>(round_depth(a, Pose(), b, pose_b).evidence);
}

void expect_exactly(const EnclosedDepth& d, double value) {
  EXPECT_EQ(d.depth.low, value);
  EXPECT_EQ(d.depth.high, value);
}

// Both ends within this part of the value.
void expect_about(const EnclosedDepth& d, double value, double part = 0x1p-20) {
  EXPECT_LE(d.depth.low, value * (1 + 0x1p-48));
  EXPECT_GE(d.depth.high, value * (1 - 0x1p-48));
  EXPECT_LE(d.depth.high - d.depth.low, part * value);
  EXPECT_FALSE(std::holds_alternative<std::monostate>(d.proof_of_low));
}

RoundBody rounded_box(double half, double radius) {
  std::vector<Point3> points;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      for (const double z : {-half, half}) points.push_back({x, y, z});
    }
  }
  return RoundBody::rounded(ConvexPolyhedron(points), radius);
}

TEST(RoundDepthTest, BallsCapsulesAndRoundedBoxes) {
  const RoundBody ball = RoundBody::ball({0, 0, 0}, 2);
  expect_exactly(depth(ball, ball, shift(3, 0, 0)), 1);
  expect_exactly(depth(ball, ball, shift(4, 0, 0)), 0);
  expect_exactly(depth(ball, ball), 4);
  EXPECT_EQ(round_depth(ball, Pose(), ball, shift(4.5, 0, 0)).verdict(), Verdict::apart);
  const EnclosedDepth off = depth(ball, ball, shift(1, 1, 0));  // 4 less the root of 2
  EXPECT_EQ(off.depth.high, std::nextafter(off.depth.low, 9));
  EXPECT_LE(off.depth.low, 4 - std::sqrt(2.0));

  // Cores that cross, and that are one above the other.
  const RoundBody along_x = RoundBody::capsule({-5, 0, 0}, {5, 0, 0}, 1),
                  along_y = RoundBody::capsule({0, -5, 0}, {0, 5, 0}, 1);
  expect_exactly(depth(along_x, along_y), 2);
  expect_exactly(depth(along_x, along_y, shift(0, 0, 1.25)), 0.75);

  expect_exactly(depth(rounded_box(2, 0.5), rounded_box(2, 0.25), shift(3, 0, 0)), 1.75);
  expect_exactly(depth(rounded_box(2, 0.5), rounded_box(2, 0.25), shift(4.5, 0, 0)), 0.25);
  expect_exactly(depth(rounded_box(2, 0), RoundBody::ball({1, 0, 0}, 3)), 4);
}

TEST(RoundDepthTest, Curved) {
  const RoundBody cylinder = RoundBody::cylinder({0, 0, -4}, {0, 0, 4}, 2);
  // Out through the side, and through the top.
  expect_about(depth(cylinder, RoundBody::ball({1.5, 0, 0}, 0.25)), 0.75);
  expect_about(depth(cylinder, RoundBody::ball({0.5, 0, 3.5}, 0.25)), 0.75);
  expect_about(depth(RoundBody::ball({0.5, 0, 3.5}, 0.25), cylinder), 0.75);
  // The centre of the ball is outside of the cylinder.
  expect_about(depth(cylinder, RoundBody::ball({3, 0, 0}, 1.25)), 0.25);
  expect_about(depth(cylinder, cylinder, shift(1, 0, 0)), 3);
  expect_about(depth(cylinder, rounded_box(1, 0), shift(2.5, 0, 0)), 0.5);
  const RoundBody cone = RoundBody::cone({0, 0, 0}, {0, 0, 4}, 3);
  expect_about(depth(cone, RoundBody::ball({0, 0, 0.5}, 0.125)), 0.625);
  // The way to the side is 3/5 of what is below the apex: 12/5 at the base.
  expect_about(depth(cone, RoundBody::ball({1.25, 0, 1}, 0)), (3 * (4 - 1) - 4 * 1.25) / 5);
  const RoundBody ellipsoid = RoundBody::ellipsoid({0, 0, 0}, {5, 3, 1});
  expect_about(depth(ellipsoid, RoundBody::ball({0, 0, 0.5}, 0.25)), 0.75);
  expect_about(depth(ellipsoid, RoundBody::ball({0, 0, 0}, 0.25)), 1.25);
  expect_about(depth(ellipsoid, rounded_box(1, 0), shift(5.5, 0, 0)), 0.5);
}

// Along all directions across the axis it is as deep; of two balls by other names, along all.
TEST(RoundDepthTest, OneAxisOrCentre) {
  const RoundBody cylinder = RoundBody::cylinder({0, 0, -40}, {0, 0, 40}, 2);
  expect_about(depth(cylinder, RoundBody::ball({0, 0, 0}, 0.25)), 2.25, 1e-3);
  const RoundBody ball = RoundBody::ellipsoid({0, 0, 0}, {1, 1, 1});
  expect_about(depth(ball, ball), 2, 2e-2);
}

TEST(RoundDepthTest, HardlyAndFarAway) {
  const RoundBody cylinder = RoundBody::cylinder({0, 0, -4}, {0, 0, 4}, 2);
  const EnclosedDepth touching = depth(cylinder, RoundBody::ball({3, 0, 0}, 1));
  EXPECT_LE(touching.depth.high, 0x1p-40);
  EXPECT_EQ(touching.depth.low, 0);
  const double s = 0x1p600;
  const RoundBody huge = RoundBody::cylinder({0, 0, -4 * s}, {0, 0, 4 * s}, 2 * s);
  expect_about(depth(huge, RoundBody::ball({1.5 * s, 0, 0}, 0.25 * s)), 0.75 * s);
}

}  // namespace
}  // namespace sunder::solid
