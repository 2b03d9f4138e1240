#include <sunder/solid/round/round_distance.h>

#include <gtest/gtest.h>

#include <cmath>

namespace sunder::solid {
namespace {

int name(const RoundBody& body) { return static_cast<int>(body.kind()); }

TEST(RoundClearance, ToTheLastBit) {
  const RoundBody a = RoundBody::ball({0, 0, 0}, 1), b = RoundBody::ball({3, 4, 0}, 2);
  EXPECT_TRUE(round_clearance(a, Pose(), b, Pose(), 2).kept());
  EXPECT_TRUE(round_clearance(a, Pose(), b, Pose(), std::nextafter(2, 0)).kept());
  EXPECT_TRUE(round_clearance(a, Pose(), b, Pose(), std::nextafter(2, 3)).broken());
  EXPECT_TRUE(round_clearance(a, Pose(), RoundBody::ball({1, 0, 0}, 1), Pose(), 1e-300).broken());
}

TEST(RoundDistance, OfEachKind) {
  const Pose at;
  const RoundBody ball = RoundBody::ball({0, 0, 7}, 2);
  for (const RoundBody& under :
       {RoundBody::cylinder({0, 0, -3}, {0, 0, 3}, 1), RoundBody::cone({0, 0, -3}, {0, 0, 3}, 1),
        RoundBody::cone({0, 0, 3}, {0, 0, -3}, 1), RoundBody::ellipsoid({0, 0, 1}, {1, 5, 2}),
        RoundBody::capsule({0, 0, -1}, {0, 0, 2}, 1)}) {
    const RoundDistance found = round_distance(under, at, ball, at);
    EXPECT_EQ(found.distance.low, 2) << name(under);
    EXPECT_LE(found.distance.high - 2, 0x1p-51) << name(under);
    EXPECT_TRUE(round_clearance(under, at, ball, at, 2).kept()) << name(under);
    EXPECT_TRUE(round_clearance(under, at, ball, at, std::nextafter(2, 3)).broken()) << name(under);
  }
  EXPECT_TRUE(round_distance(ball, at, RoundBody::cylinder({-1, 0, 5}, {1, 0, 5}, 1), at).meet());
}

}  // namespace
}  // namespace sunder::solid
