#include <sunder/base/random.h>
#include <sunder/solid/object/flatness.h>
#include <sunder/solid/object/frame.h>

#include <gtest/gtest.h>
#include <tests/support/scale.h>

#include <cmath>
#include <vector>

namespace sunder::solid {
namespace {

TEST(Flatness, ByHowMuch) {
  std::vector<Point3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_TRUE(flatness(square).is_flat);
  square[2].z = 5e-324;
  const Flatness last_bit = flatness(square);
  EXPECT_FALSE(last_bit.is_flat);
  square[3].z = 0.25;
  const Flatness bent = flatness(square);
  EXPECT_FALSE(bent.is_flat);
  EXPECT_GT(bent.distance, 0.1);
  EXPECT_LT(bent.distance, 0.3);
  square[2].z = 0;
  square[3].z = 0x1p-40;
  EXPECT_NEAR(flatness(square).distance, 0x1p-40, 0x1p-42);
  // Collinear points, one point many times, and points of which only the last leaves their line.
  EXPECT_TRUE(flatness(std::vector<Point3>(7, Point3{1, 2, 3})).is_flat);
  std::vector<Point3> line;
  for (int k = 0; k < 9; ++k) line.push_back({k * 0.5, k * 1.0, -k * 2.0});
  EXPECT_TRUE(flatness(line).is_flat);
  line.push_back({0, 0, 5e-324});
  EXPECT_TRUE(flatness(line).is_flat);
  line.push_back({0, 5e-324, 0});
  EXPECT_FALSE(flatness(line).is_flat);
  std::vector<Point3> huge{{1e308, 1e308, 0}, {-1e308, 1e308, 0}, {-1e308, -1e308, 0}, {1e308, -1e308, 0}};
  EXPECT_TRUE(flatness(huge).is_flat);
  huge[1].z = 1;
  EXPECT_FALSE(flatness(huge).is_flat);
}

// A plane z = small integers of x and y, with one vertex off by one bit.
TEST(Flatness, Random) {
  const int count = tests::scaled_count(2000);
  Random random(tests::chosen_seed(20261125));
  const auto small = [&] { return static_cast<double>(random.between(-9, 9)); };
  for (int i = 0; i < count; ++i) {
    const double p = small(), q = small(), r = small();
    std::vector<Point3> points;
    for (std::uint64_t n = 4 + random.below(6); n > 0; --n) {
      const double x = small(), y = small();
      points.push_back({x, y, p * x + q * y + r});
    }
    ASSERT_TRUE(flatness(points).is_flat);
    const std::uint64_t k = random.below(points.size());
    const double z = points[k].z;
    points[k].z = std::nextafter(z, 1e9);
    const Flatness off = flatness(points);
    if (off.is_flat) continue;  // the others are on a line, perhaps with this one
    if (z != 0) {
      ASSERT_GT(off.distance, 0);
    }
    // Not more than any point moved, times what a base of the plane can magnify.
    ASSERT_LT(off.distance, 1e3 * (points[k].z - z));
  }
}

TEST(Frame, IsAPose) {
  const Frame frame = Frame::of({1, 2, 3}, {0, 2, 0}, {0, 0, 5});
  const Pose pose = frame.pose();
  const Affine3& m = pose.affine();
  EXPECT_EQ(m.linear[0] + m.linear[1], 0);
  EXPECT_EQ(m.linear[3], 2);
  EXPECT_EQ(m.linear[7], 5);
  EXPECT_EQ(m.translation[2], 3);
  EXPECT_THROW(Frame::of({}, {1, 2, 3}, {2, 4, 6}), Error);
  EXPECT_THROW(Frame::of({}, {1, 2, 3}, {}), Error);
  EXPECT_THROW(Frame::of({}, {1, 2, 3}, {HUGE_VAL, 0, 0}), Error);
  // Nearly parallel, so that the rounded cross product is zero, and tiny, so that it underflows.
  EXPECT_NO_THROW(Frame::of({}, {1, 1, 0}, {1 + 0x1p-52, 1, 0}));
  EXPECT_NO_THROW(Frame::of({}, {1e-300, 0, 0}, {0, 1e-300, 0}));
}

}  // namespace
}  // namespace sunder::solid
