#include <sunder/base/random.h>
#include <sunder/planar/object/polygon.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sunder::planar {
namespace {

using Ring = std::vector<Point2>;

bool strictly_convex(const std::vector<Ring>& rings) { return Polygon(rings).strictly_convex(); }

// n points of a circle, each so many steps after the one before.
Ring star(std::size_t n, std::size_t steps) {
  Ring ring;
  for (std::size_t k = 0; k < n; ++k) {
    ring.push_back(tests::on_circle(static_cast<double>(k * steps % n) / static_cast<double>(n)));
  }
  return ring;
}

TEST(PolygonTest, StrictlyConvexWhereItTurnsOnceToOneSide) {
  for (const std::size_t n : {3U, 4U, 5U, 17U, 1000U}) {
    Ring ring = star(n, 1);
    for (int turn = 0; turn < 2; ++turn) {
      EXPECT_TRUE(strictly_convex({ring})) << n;
      EXPECT_FALSE(strictly_convex({ring, ring})) << n;
      Ring closed = ring;
      closed.push_back(ring[0]);
      EXPECT_TRUE(strictly_convex({closed})) << n;
      closed.push_back(ring[1]);
      EXPECT_FALSE(strictly_convex({closed})) << n;
      std::reverse(ring.begin(), ring.end());
    }
  }
  EXPECT_FALSE(strictly_convex({star(5, 2)}));  // it turns left only, but goes round twice
  EXPECT_FALSE(strictly_convex({star(9, 4)}));
  EXPECT_FALSE(strictly_convex({star(7, 3)}));
  EXPECT_FALSE(strictly_convex({{{0, 0}, {1, 0}, {2, 0}, {1, 1}}}));
  EXPECT_FALSE(strictly_convex({{{0, 0}, {1, 1}, {2, 2}}}));
  EXPECT_FALSE(strictly_convex({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}));
  EXPECT_FALSE(strictly_convex({{{0, 0}, {4, 0}, {4, 4}, {3, 1}}}));
  EXPECT_FALSE(strictly_convex({{{0, 0}, {0, 0}, {1, 0}, {0, 1}}}));
  for (const double size : {5e-324, 0x1p-500, 0x1p1023}) {
    EXPECT_TRUE(strictly_convex({{{0, 0}, {size, 0}, {0, size}}})) << size;
    EXPECT_FALSE(strictly_convex({{{0, 0}, {size, size}, {size, 0}, {0, size}}})) << size;
  }
  EXPECT_TRUE(strictly_convex({{{0, 0}, {1, 0x1p-1074}, {2, 0x1p-1072}, {0, 1}}}));  // by the last bit
  EXPECT_FALSE(strictly_convex({{{0, 0}, {1, 0x1p-1074}, {2, 0x1p-1073}, {0, 1}}}));
}

// Rings of small whole numbers: those that have all other vertices strictly on one side of each
// edge, on the same one, and no others.
TEST(PolygonTest, StrictlyConvexMeansAllOnOneSideOfEachEdge) {
  Random random(tests::chosen_seed(20261129));
  int convex = 0, only_turning = 0;
  const int count = tests::scaled_count(20000, 2000);
  for (int i = 0; i < count; ++i) {
    Ring ring(3 + random.below(5));
    for (Point2& p : ring) {
      p = {static_cast<double>(random.between(-3, 3)), static_cast<double>(random.between(-3, 3))};
    }
    if (ring.front() == ring.back()) continue;
    const std::size_t n = ring.size();
    std::size_t left = 0, right = 0, turns_left = 0, turns_right = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Point2 &a = ring[k], &b = ring[(k + 1) % n];
      for (std::size_t l = 2; l < n; ++l) {
        const Point2& c = ring[(k + l) % n];
        const double side = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        left += side > 0;
        right += side < 0;
        turns_left += l == 2 && side > 0;
        turns_right += l == 2 && side < 0;
      }
    }
    const bool expected = left == n * (n - 2) || right == n * (n - 2);
    ASSERT_EQ(strictly_convex({ring}), expected) << i;
    convex += expected;
    only_turning += !expected && (turns_left == n || turns_right == n);
  }
  EXPECT_GT(convex, count / 50);
  EXPECT_GT(only_turning, 0);
}

}  // namespace
}  // namespace sunder::planar
