#include <sunder/base/random.h>
#include <sunder/predicate/point/plane_side.h>
#include <sunder/predicate/point/plane_sides.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sunder {
namespace {

double wild(Random& random, int reach) {
  if (reach <= 2) return static_cast<double>(random.between(-4, 4));
  const int exponent = static_cast<int>(random.between(-reach, reach));
  return random.below(6) == 0 ? 0 : std::ldexp(random.uniform(-1, 1), exponent);
}

// Numbers of any size, and points that are next to the plane or on it: the signs are those of side_of_plane.
TEST(PlaneSidesTest, AgreesWithTheOneByOnePredicate) {
  Random random(20260303);
  StageTally tally;
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const int reach = std::array{2, 2, 40, 300, 1000}[random.below(5)];
    Affine3 pose;
    if (random.below(3) > 0) {
      for (double& x : pose.linear) x = wild(random, reach / 2);
      for (double& x : pose.translation) x = wild(random, reach / 2);
    }
    Point3 normal{wild(random, reach), wild(random, reach), wild(random, reach)};
    if (normal == Point3{}) normal.y = 1;
    const Point3 point{wild(random, reach / 2), wild(random, reach / 2), wild(random, reach / 2)};
    const Point3 p{wild(random, reach / 2), wild(random, reach / 2), wild(random, reach / 2)};
    const SizeRange linear = size_range(std::span<const double>(pose.linear)),
                    translation = size_range(std::span<const double>(pose.translation)),
                    coordinates = size_range({&p, 1});
    PlaneSides sides(normal, point, pose, images_are_tame(linear, translation, coordinates), coordinates.greatest);
    const double through = dot(Vector3<double>{normal.x, normal.y, normal.z},
                               rounded_image(posed(p, pose)) - Vector3<double>{point.x, point.y, point.z});
    for (const double offset : {0.0, wild(random, reach), through, std::nextafter(through, 1e308)}) {
      if (!std::isfinite(offset)) continue;
      sides.set_offset(offset);
      const Sign expected = side_of_plane(normal, point, offset, posed(p, pose));
      ASSERT_EQ(sides(p, &tally), expected) << i;
      zeros += expected == Sign::zero;
    }
  }
  EXPECT_GT(zeros, 1000);
  EXPECT_GT(tally.rounded, 20000u);
  EXPECT_GT(tally.interval, 1000u);
  EXPECT_GT(tally.exact, 1000u);
}

// The filter decides where a body is a unit large, and the point a billionth beside the plane.
TEST(PlaneSidesTest, FloatingPointDecidesNextToThePlane) {
  const Affine3 pose;
  PlaneSides sides({0, 0, 5}, {0, 0, 0.25}, pose, true, 1);
  sides.set_offset(1.25);
  StageTally tally;
  EXPECT_EQ(sides({0.1, 0.7, 0.5 + 1e-9}, &tally), Sign::positive);
  EXPECT_EQ(sides({0.1, 0.7, 0.5 - 1e-9}, &tally), Sign::negative);
  EXPECT_EQ(tally.rounded, 2u);
  EXPECT_EQ(sides({0.1, 0.7, 0.5}, &tally), Sign::zero);
  EXPECT_EQ(tally.exact, 1u);
}

TEST(PlaneSidesTest, TurnsAsSeenFromTheNormal) {
  const Affine3 pose;
  const auto at = [&](double x, double y, double z) { return posed(Point3{x, y, z}, pose); };
  EXPECT_EQ(turn_seen_from({0, 0, 1}, at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)), Sign::positive);
  EXPECT_EQ(turn_seen_from({0, 0, -1}, at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)), Sign::negative);
  EXPECT_EQ(turn_seen_from({1, 1, 0}, at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)), Sign::zero);
}

}  // namespace
}  // namespace sunder
