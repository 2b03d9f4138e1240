#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/pair/polytope_point.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <utility>
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

// Points in general position: simplices are facets, and 2 n - 4 of them in space; each ridge is of two (Dehn and
// Sommerville: 2 f(d-2) = d f(d-1)), and Euler's sum in four dimensions is f1 = f0 + f3, as f2 = 2 f3.
TEST(ConvexHullOfPolytope, EulersFormulaHolds) {
  Random random(sunder::tests::chosen_seed(7));
  for (std::size_t d = 3; d <= 4; ++d) {
    std::vector<double> numbers;
    for (int k = 0; k < 300; ++k) {
      double square = 0;
      std::vector<double> p(d);
      for (double& x : p) {
        x = random.uniform(-1, 1);
        square += x * x;
      }
      for (const double x : p) numbers.push_back(x / std::sqrt(square));
    }
    const ConvexHull hull = convex_hull(Polytope::from_points(d, numbers));
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t f = 0; f < hull.facet_count(); ++f) {
      const auto here = hull.facet_vertices(f);
      ASSERT_EQ(here.size(), d);
      for (std::size_t i = 0; i < d; ++i) {
        for (std::size_t j = 0; j < i; ++j) edges.insert({here[j], here[i]});
      }
    }
    const std::size_t n = hull.vertices.size();
    EXPECT_EQ(n, 300u);
    if (d == 3) {
      EXPECT_EQ(hull.facet_count(), 2 * n - 4);
      EXPECT_EQ(edges.size(), 3 * n - 6);
    } else {
      EXPECT_EQ(edges.size(), n + hull.facet_count());
    }
  }
}

TEST(ConvexHullOfPolytope, OfEqualPointsTheFirstIsAVertex) {
  const ConvexHull hull = convex_hull(Polytope::from_points(2, {1, 1, 0, 0, 0, -0.0, 4, 0, 4, 0, 0, 4, 0, 4}));
  EXPECT_EQ(hull.vertices, (std::vector<std::uint32_t>{1, 3, 5}));
  const ConvexHull segment = convex_hull(Polytope::from_points(3, {1, 1, 1, 1, 1, 1, 2, 2, 2, 0, 0, 0, 2, 2, 2}));
  EXPECT_EQ(segment.vertices, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(segment.facet_count(), 2u);
}

TEST(ConvexHullOfPolytope, TooManySimplicesAreRefused) {
  const Polytope points = cyclic(6, 20);
  EXPECT_NO_THROW((void)convex_hull(points, 1000));
  try {
    (void)convex_hull(points, 300);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_shape);
    EXPECT_STREQ(error.what(),
                 "a hull of more than 300 simplices at once, the limit; give fewer points, or fewer columns");
  }
}

// Many points on facets: some are added before what they are between of, and are no vertices in the end.
TEST(ConvexHullOfPolytope, VerticesAreThoseThatAreNotInTheHullOfTheOthers) {
  Random random(sunder::tests::chosen_seed(5));
  for (int turn = 0; turn < std::max(6, sunder::tests::scaled_count(20)); ++turn) {
    const std::size_t d = 3 + static_cast<std::size_t>(turn % 2);
    std::set<std::vector<double>> rows;
    while (rows.size() < 50) {
      std::vector<double> p;
      for (std::size_t c = 0; c < d; ++c) p.push_back(static_cast<double>(random.between(-3, 3)));
      rows.insert(p);
    }
    std::vector<double> numbers;
    for (const auto& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
    const ConvexHull hull = convex_hull(Polytope::from_points(d, numbers));
    for (std::uint32_t k = 0; k < rows.size(); ++k) {
      std::vector<double> others = numbers;
      const auto begin = others.begin() + static_cast<std::ptrdiff_t>(k * d);
      others.erase(begin, begin + static_cast<std::ptrdiff_t>(d));
      const std::span point(numbers.data() + k * d, d);
      const bool is_vertex = std::binary_search(hull.vertices.begin(), hull.vertices.end(), k);
      EXPECT_EQ(polytope_point(Polytope::from_points(d, others), point).meet(), !is_vertex) << turn << " " << k;
    }
  }
}

// Few bits: no sign is left to exact numbers, though most points are on facets and on edges.
TEST(ConvexHullOfPolytope, GridsOfWholeNumbersAreDecidedInFloatingPoint) {
  std::vector<double> numbers;
  for (int k = 0; k < 625; ++k)
    numbers.insert(numbers.end(), {k % 5 + 0.25, k / 5 % 5 * 8.0, k / 25 % 5 - 2.0, k / 125 * 0x1p900});
  const ConvexHull hull = convex_hull(Polytope::from_points(4, numbers));
  EXPECT_EQ(hull.facet_count(), 8u);
  EXPECT_EQ(hull.exact_tests, 0u);
}

}  // namespace
}  // namespace sunder::polytope
