#include <sunder/polytope/object/pose.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace sunder::polytope {
namespace {

TEST(PolytopePose, RefusesWhatIsNone) {
  const std::vector<double> moved{1, 2}, swap{0, 1, 1, 0};
  EXPECT_FALSE(Pose::from_matrix(2, swap, moved).is_identity());
  EXPECT_TRUE(Pose::from_matrix(2, std::vector<double>{1, 0, 0, 1}, std::vector<double>{0, 0}).is_identity());
  EXPECT_THROW(Pose::from_matrix(2, std::vector<double>{1, 2, 2, 4}, moved), Error);
  EXPECT_THROW(Pose::from_matrix(2, std::vector<double>{0, 0, 0, 0}, moved), Error);
  EXPECT_THROW(Pose::from_matrix(3, swap, moved), Error);
  EXPECT_THROW(Pose::from_matrix(1, std::vector<double>{1}, std::vector<double>{1}), Error);
  EXPECT_THROW(Pose::from_matrix(2, swap, std::vector<double>{1, std::numeric_limits<double>::infinity()}), Error);
}

}  // namespace
}  // namespace sunder::polytope
