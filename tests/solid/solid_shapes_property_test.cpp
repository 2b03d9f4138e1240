// The families of hard bodies are what they say.
#include <tests/support/scale.h>
#include <tests/support/solid_shapes.h>

#include <sunder/solid/object/convex_polyhedron.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexHull;
using solid::ConvexPolyhedron;

TEST(SolidShapes, HaveTheVerticesAndTheDegreeTheySay) {
  for (const SolidShape& shape : all_solid_shapes()) {
    for (const std::size_t n : {8u, 9u, 12u, 13u, 27u, 64u, 97u, 200u, 1001u}) {
      SCOPED_TRACE(std::string(shape.name) + " of " + std::to_string(n));
      Random random(chosen_seed(18));
      const ConvexPolyhedron body(shape.make(n, random));
      const auto count = static_cast<std::uint32_t>(body.vertices().size());
      EXPECT_EQ(count, shape.vertex_count(n));
      std::size_t degree = 0;
      for (std::uint32_t v = 0; v < count; ++v) degree = std::max(degree, body.neighbours(v).size());
      if (shape.greatest_degree != nullptr) {
        EXPECT_EQ(degree, shape.greatest_degree(n));
      } else if (n >= 64) {
        EXPECT_LT(degree, n / 4);
      }
      EXPECT_EQ(body.dimension(), shape.name == "flat" ? 2 : 3);
    }
  }
}

TEST(SolidShapes, KeepTheirVerticesWhereTheyAreMany) {
  for (const SolidShape& shape : all_solid_shapes()) {
    const std::size_t n = std::size_t{1} << (is_scaled_down() ? 13 : 17);
    Random random(chosen_seed(18));
    const ConvexHull hull = solid::convex_hull(shape.make(n, random));
    EXPECT_EQ(hull.vertices.size(), shape.vertex_count(n)) << shape.name;
  }
}

TEST(SolidShapes, AreTheSameFromASeed) {
  for (const SolidShape& shape : all_solid_shapes()) {
    Random first(3), second(3);
    EXPECT_EQ(shape.make(100, first), shape.make(100, second)) << shape.name;
  }
}

// In a whole number of rounds the first vertex joins all others, those of the last round have three neighbours, those
// of the round before two more, and so on: each vertex was above one facet only.
TEST(SolidShapes, StackedOnesAreStacked) {
  for (const int rounds : {0, 1, 2, 5, 10, 15}) {
    const std::size_t n = 1 + (std::size_t{3} << rounds);
    const std::vector<Point3> points = solid_shapes::stacked(n);
    const ConvexHull hull = solid::convex_hull(points);
    ASSERT_EQ(hull.vertices.size(), n);
    ASSERT_EQ(hull.facet_begin.size(), 2 * n - 4 + 1) << "not all of them triangles";
    const auto degree = [&](std::size_t v) { return hull.neighbour_begin[v + 1] - hull.neighbour_begin[v]; };
    EXPECT_EQ(degree(0), n - 1);
    std::size_t v = 1;
    for (int round = 0; round <= rounds; ++round) {
      const std::size_t end = 1 + (std::size_t{3} << round);
      for (; v < end; ++v) ASSERT_EQ(degree(v), 3u + 2u * static_cast<unsigned>(rounds - round)) << v;
    }
  }
}

}  // namespace
}  // namespace sunder::tests
