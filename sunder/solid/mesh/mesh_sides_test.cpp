#include <sunder/solid/mesh/mesh_sides.h>

#include <sunder/base/random.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder::solid {
namespace {

TEST(MeshSides, LowestOfEqualsIsTheFirstOne) {
  Random random(6101);
  for (std::uint64_t n : {0u, 1u, 2u, 3u, 50u, 3000u}) {
    for (const int size : {0, 3, 1000}) {
      std::vector<Point3> points;
      const auto whole = [&] {
        const auto x = static_cast<double>(random.between(-size, size));
        return x == 0 && random.below(2) == 0 ? -0.0 : x;  // which is equal
      };
      while (points.size() < n) points.push_back({whole(), whole(), whole()});
      const std::vector<std::uint32_t> lowest = lowest_of_equals(points);
      ASSERT_EQ(lowest, lowest_of_equals_by_sorting(points)) << n << ' ' << size;
      for (std::size_t i = 0; i < n && n <= 50; ++i) {
        std::uint32_t first = 0;
        while (points[first] != points[i]) ++first;
        EXPECT_EQ(lowest[i], first) << n << ' ' << size;
      }
    }
  }
}

TEST(MeshSides, SidesAreSortedByTheirEnds) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};  // 3 is 1
  const std::vector<std::uint32_t> begin{0, 4, 7}, corners{0, 1, 3, 2, 2, 3, 4};
  const MeshSides sides(MeshView{points, begin, corners});
  EXPECT_EQ(sides.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 4}));
  ASSERT_EQ(sides.sides.size(), 6u);
  for (std::size_t k = 1; k < 6; ++k) EXPECT_LE(sides.sides[k - 1].ends(), sides.sides[k].ends());
  EXPECT_EQ(sides.sides[2].ends(), (std::pair<std::uint32_t, std::uint32_t>(1, 2)));
  EXPECT_EQ(sides.sides[2].face, 0u);
  EXPECT_EQ(sides.sides[3].ends(), (std::pair<std::uint32_t, std::uint32_t>(1, 2)));
  EXPECT_EQ(sides.sides[3].face, 1u);
}

}  // namespace
}  // namespace sunder::solid
