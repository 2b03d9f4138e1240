#include <sunder/base/error.h>
#include <sunder/planar/object/pose.h>

#include <gtest/gtest.h>

#include <limits>

namespace sunder::planar {
namespace {

TEST(PlanarPoseTest, Kinds) {
  EXPECT_TRUE(Pose().is_identity());
  EXPECT_FALSE(Pose().reflects());
  const Pose mirror = Pose::from_matrix({1, 0, 0, -1}, {5, 6});
  EXPECT_TRUE(mirror.reflects());
  EXPECT_FALSE(mirror.is_identity());
  const Pose turn = Pose::from_angle(0.5, {1, 2});
  EXPECT_FALSE(turn.reflects());
  EXPECT_GT(turn.affine().linear[2], 0);  // counter-clockwise
  EXPECT_EQ(turn.affine().translation[1], 2);
  const Affine3 space = in_space(mirror.affine());
  EXPECT_EQ(space.linear, (std::array<double, 9>{1, 0, 0, 0, -1, 0, 0, 0, 1}));
  EXPECT_EQ(space.translation, (std::array<double, 3>{5, 6, 0}));
}

TEST(PlanarPoseTest, RefusesWhatIsNoPose) {
  EXPECT_THROW(Pose::from_matrix({1, 2, 2, 4}, {0, 0}), Error);
  EXPECT_THROW(Pose::from_matrix({0, 0, 0, 0}, {0, 0}), Error);
  EXPECT_THROW(Pose::from_matrix({1, 0, 0, std::numeric_limits<double>::quiet_NaN()}, {0, 0}), Error);
  EXPECT_THROW(Pose::from_matrix({1, 0, 0, 1}, {0, std::numeric_limits<double>::infinity()}), Error);
  EXPECT_THROW(Pose::from_angle(std::numeric_limits<double>::infinity(), {0, 0}), Error);
  EXPECT_NO_THROW(Pose::from_matrix({1e-300, 0, 0, 1e-300}, {0, 0}));  // the determinant underflows, and is not zero
}

}  // namespace
}  // namespace sunder::planar
