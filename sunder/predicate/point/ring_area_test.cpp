#include <sunder/predicate/point/ring_area.h>

#include <sunder/base/random.h>
#include <sunder/predicate/point/orient.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace sunder {
namespace {

TEST(RingArea, OfThreePointsIsTheirTurn) {
  Random random(4021);
  const std::array<std::uint32_t, 3> ring{0, 1, 2};
  std::array<int, 3> seen{};
  for (int i = 0; i < 3000; ++i) {
    std::array<Point3, 3> p;
    for (Point3& q : p) {
      for (std::size_t c = 0; c < 3; ++c) q[c] = static_cast<double>(random.between(-2, 2));
    }
    if (i % 2 == 0) p[2].y = std::nextafter(p[2].y, 9);
    for (int axis = 0; axis < 3; ++axis) {
      const Sign sign = ring_area_along(axis, p, ring);
      EXPECT_EQ(sign, orient_2d_along(axis, p[0], p[1], p[2]));
      ++seen[sign == Sign::negative ? 0 : sign == Sign::zero ? 1 : 2];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(RingArea, OfRingsThatCrossThemselves) {
  const std::vector<Point3> points{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0x1.0000000000001p+1, 0}};
  EXPECT_EQ(ring_area_along(2, points, std::array<std::uint32_t, 4>{0, 1, 2, 3}), Sign::zero);  // a bow-tie
  EXPECT_EQ(ring_area_along(2, points, std::array<std::uint32_t, 4>{0, 1, 2, 4}), Sign::positive);
  EXPECT_EQ(ring_area_along(2, points, std::array<std::uint32_t, 4>{4, 2, 1, 0}), Sign::negative);
  EXPECT_EQ(ring_area_along(2, points, std::array<std::uint32_t, 1>{0}), Sign::zero);
}

}  // namespace
}  // namespace sunder
