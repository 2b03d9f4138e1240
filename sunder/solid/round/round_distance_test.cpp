#include <sunder/solid/round/round_distance.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sunder::solid {
namespace {

int name(const RoundBody& body) { return static_cast<int>(body.kind()); }

TEST(RoundClearance, ToTheLastBit) {
  const RoundBody a = RoundBody::ball({0, 0, 0}, 1), b = RoundBody::ball({3, 4, 0}, 2);
  EXPECT_TRUE(is_kept(round_clearance(a, Pose(), b, Pose(), 2)));
  EXPECT_TRUE(is_kept(round_clearance(a, Pose(), b, Pose(), std::nextafter(2, 0))));
  EXPECT_TRUE(is_broken(round_clearance(a, Pose(), b, Pose(), std::nextafter(2, 3))));
  EXPECT_TRUE(is_broken(round_clearance(a, Pose(), RoundBody::ball({1, 0, 0}, 1), Pose(), 1e-300)));
}

TEST(RoundDistance, OfEachKind) {
  const Pose at;
  const RoundBody ball = RoundBody::ball({0, 0, 7}, 2);
  for (const RoundBody& under :
       {RoundBody::cylinder({0, 0, -3}, {0, 0, 3}, 1), RoundBody::cone({0, 0, -3}, {0, 0, 3}, 1),
        RoundBody::cone({0, 0, 3}, {0, 0, -3}, 1), RoundBody::ellipsoid({0, 0, 1}, {1, 5, 2}),
        RoundBody::capsule({0, 0, -1}, {0, 0, 2}, 1)}) {
    const Interval found = distance_of(round_distance(under, at, ball, at));
    EXPECT_EQ(found.low, 2) << name(under);
    EXPECT_LE(found.high - 2, 0x1p-51) << name(under);
    EXPECT_TRUE(is_kept(round_clearance(under, at, ball, at, 2))) << name(under);
    EXPECT_TRUE(is_broken(round_clearance(under, at, ball, at, std::nextafter(2, 3)))) << name(under);
  }
  EXPECT_TRUE(round_distance(ball, at, RoundBody::cylinder({-1, 0, 5}, {1, 0, 5}, 1), at).meet());
}

// Along (2, 3, 6), which is no double: exactly so far is kept.
TEST(RoundClearance, ExactlySoFarAlongFractions) {
  const RoundBody ball = RoundBody::ball({4, 6, 12}, 2), other = RoundBody::ellipsoid({0, 0, 0}, {3, 3, 3});
  EXPECT_EQ(distance_of(round_distance(ball, Pose(), other, Pose())).low, 9);
  EXPECT_TRUE(is_kept(round_clearance(ball, Pose(), other, Pose(), 9)));
  EXPECT_TRUE(is_broken(round_clearance(other, Pose(), ball, Pose(), std::nextafter(9, 10))));
}

// Beyond the range of doubles, and far below the size of the bodies.
TEST(RoundDistance, AtTheEndsOfDoubles) {
  const double largest = std::numeric_limits<double>::max();
  const RoundBody a = RoundBody::ball({-largest, 0, 0}, 1), b = RoundBody::ball({largest, 0, 0}, 1);
  const Interval far = distance_of(round_distance(a, Pose(), b, Pose()));
  EXPECT_EQ(far.low, largest);
  EXPECT_TRUE(std::isinf(far.high));
  EXPECT_TRUE(is_kept(round_clearance(a, Pose(), b, Pose(), largest)));
  const RoundBody low = RoundBody::cylinder({0, 0, -1}, {0, 0, 0}, 1), high = RoundBody::cone({0, 0, 1}, {0, 0, 0}, 1);
  EXPECT_TRUE(round_distance(low, Pose(), high, Pose()).meet());
  const Pose up = Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 5e-324});
  const Interval least = distance_of(round_distance(low, Pose(), high, up));
  EXPECT_EQ(least.low, 5e-324);
  EXPECT_TRUE(is_kept(round_clearance(low, Pose(), high, up, 5e-324)));
}

}  // namespace
}  // namespace sunder::solid
