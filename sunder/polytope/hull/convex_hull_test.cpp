#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/polytope/hull/convex_hull.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sunder::polytope {
namespace {

// Points on the moment curve: whole numbers.
Polytope cyclic(std::size_t d, int count) {
  std::vector<double> numbers;
  for (int k = 0; k < count; ++k) {
    double power = 1;
    for (std::size_t c = 0; c < d; ++c) numbers.push_back(power *= k - count / 2);
  }
  return Polytope::from_points(d, std::move(numbers));
}

std::size_t choose(std::size_t n, std::size_t k) {
  std::size_t result = 1;
  for (std::size_t i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

// Gale's evenness condition: C(n - ceil(d/2), n - d) + C(n - floor(d/2) - 1, n - d).
TEST(ConvexHullOfPolytope, ACyclicPolytopeHasAsManyFacetsAsCanBe) {
  for (std::size_t d = 2; d <= 6; ++d) {
    for (const int count : {8, 13, 20}) {
      const ConvexHull hull = convex_hull(cyclic(d, count));
      const auto n = static_cast<std::size_t>(count);
      EXPECT_EQ(hull.vertices.size(), n);
      EXPECT_EQ(hull.facet_count(), choose(n - (d + 1) / 2, n - d) + choose(n - d / 2 - 1, n - d)) << d << " " << n;
      EXPECT_EQ(hull.facet_count(), hull.simplex_count());
    }
  }
}

TEST(ConvexHullOfPolytope, AGridIsACube) {
  for (std::size_t d = 2; d <= 5; ++d) {
    std::vector<double> numbers;
    std::size_t count = 1;
    for (std::size_t c = 0; c < d; ++c) count *= 4;
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t c = 0, rest = k; c < d; ++c, rest /= 4)
        numbers.push_back(0.1 + 0.7 * static_cast<double>(rest % 4));
    }
    const Polytope grid = Polytope::from_points(d, std::move(numbers));
    const ConvexHull hull = convex_hull(grid);
    EXPECT_EQ(hull.dimension, d);
    EXPECT_EQ(hull.vertices.size(), std::size_t{1} << d);
    ASSERT_EQ(hull.facet_count(), 2 * d);
    for (std::size_t f = 0; f < 2 * d; ++f) EXPECT_EQ(hull.facet_vertices(f).size(), std::size_t{1} << (d - 1));
  }
}

}  // namespace
}  // namespace sunder::polytope
