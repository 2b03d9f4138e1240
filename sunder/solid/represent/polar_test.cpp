// The polar about a point inside: its combinatorics and its exact vertices on every family of hard bodies.
#include <sunder/base/error.h>
#include <sunder/number/dyadic.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/represent/polar.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace sunder::solid {
namespace {

using Arrow = std::array<Dyadic, 3>;

// Numbers of exact_polar_vertex are 4 n and 4 h, arrows 4 times too.
Dyadic dot(const Arrow& a, const Arrow& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Arrow cross(const Arrow& a, const Arrow& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Four times the arrow from o to a vertex, the base summed first.
Arrow from_center(const ConvexPolyhedron& body, std::uint32_t v) {
  Arrow arrow;
  for (std::size_t k = 0; k < 3; ++k) {
    Dyadic sum;
    for (const std::uint32_t b : represent::of<Polar>(body).base) sum = sum + Dyadic(body.vertices()[b][k]);
    arrow[k] = Dyadic(body.vertices()[v][k]).scaled(2) - sum;
  }
  return arrow;
}

template <class Numbers>
std::vector<std::uint32_t> part(const Numbers& numbers, const std::vector<std::uint32_t>& begin, std::uint32_t i) {
  return {numbers.begin() + begin[i], numbers.begin() + begin[i + 1]};
}

// Lemma 3.1 about o: vertex f is on the plane of v if v is on that of f, else within it. With this for all pairs the
// polar is P's, and what its facets have is right.
void check_polar(const ConvexPolyhedron& body) {
  const Polar& polar = represent::of<Polar>(body);
  const std::uint32_t n = static_cast<std::uint32_t>(body.vertices().size()), m = body.facet_count();
  ASSERT_EQ(polar.vertices.size(), m);
  ASSERT_EQ(polar.edge_begin.size(), m + 1);
  ASSERT_EQ(polar.facet_begin.size(), n + 1);
  ASSERT_EQ(polar.neighbours.size(), polar.facet_vertices.size());
  ASSERT_EQ(polar.neighbours.size(), 2 * (n + m - 2));  // Euler

  std::vector<PolarVertex> exact;
  for (std::uint32_t f = 0; f < m; ++f) {
    exact.push_back(exact_polar_vertex(body.vertices(), body.facet(f), polar.base));
    ASSERT_EQ(exact[f].h.sign(), Sign::positive);
  }
  for (std::uint32_t v = 0; v < n; ++v) {
    const Arrow arrow = from_center(body, v);
    const std::vector<std::uint32_t> cycle = part(polar.facet_vertices, polar.facet_begin, v);
    const std::set<std::uint32_t> on_facet(cycle.begin(), cycle.end());
    ASSERT_EQ(on_facet.size(), cycle.size());
    for (std::uint32_t f = 0; f < m; ++f) {
      const auto facet = body.facet(f);
      const Sign side = (exact[f].h.scaled(2) - dot(exact[f].n, arrow)).sign();
      ASSERT_EQ(side, on_facet.count(f) != 0 ? Sign::zero : Sign::positive);
      ASSERT_EQ(std::count(facet.begin(), facet.end(), v) == 1, on_facet.count(f) != 0);
    }
    // Counter-clockwise: any three in a row turn to the left, seen from outside; each is joined to the next by an edge.
    for (std::size_t j = 0; j < cycle.size(); ++j) {
      const std::uint32_t f = cycle[j], g = cycle[(j + 1) % cycle.size()], h = cycle[(j + 2) % cycle.size()];
      ASSERT_EQ(dot(cross(exact[f].n, exact[g].n), exact[h].n).sign(), Sign::positive);
      const std::vector<std::uint32_t> around = part(polar.neighbours, polar.edge_begin, f);
      ASSERT_EQ(std::count(around.begin(), around.end(), g), 1);
    }
  }
  // The j-th neighbour is across the j-th edge.
  for (std::uint32_t f = 0; f < m; ++f) {
    const auto facet = body.facet(f);
    const std::vector<std::uint32_t> around = part(polar.neighbours, polar.edge_begin, f);
    ASSERT_EQ(around.size(), facet.size());
    for (std::size_t j = 0; j < facet.size(); ++j) {
      const auto beyond = body.facet(around[j]);
      for (const std::uint32_t v : {facet[j], facet[(j + 1) % facet.size()]}) {
        ASSERT_EQ(std::count(beyond.begin(), beyond.end(), v), 1);
      }
      ASSERT_NE(around[j], f);
    }
    // Doubles are near the exact vertex.
    double error = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = nearest_ratio(exact[f].n[k], exact[f].h);
      if (!std::isfinite(expected)) return;
      error = std::max(error, std::fabs(polar.vertices[f][k] - expected));
      size = std::max(size, std::fabs(expected));
    }
    ASSERT_LE(error, 0x1p-28 * size);
  }
}

TEST(Polar, OfHardBodies) {
  for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
    for (const std::size_t n : {8u, 9u, 27u, 64u}) {
      SCOPED_TRACE(std::string(shape.name) + " of " + std::to_string(n));
      Random random(tests::chosen_seed(18));
      const ConvexPolyhedron body(shape.make(n, random));
      if (body.dimension() < 3) continue;
      ASSERT_NO_FATAL_FAILURE(check_polar(body));
    }
  }
}

TEST(Polar, OfSmallWholeNumbers) {
  const std::uint64_t seed = tests::chosen_seed(19);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int run = 0; run < tests::scaled_count(200); ++run) {
    std::vector<Point3> points(4 + random.below(20));
    for (Point3& p : points) p = tests::on_grid(random, random.between(1, 3));
    const ConvexPolyhedron body(points);
    if (body.dimension() < 3) continue;
    ASSERT_NO_FATAL_FAILURE(check_polar(body)) << "run " << run;
  }
}

// The regular octahedron about the origin of a cube, in numbers.
TEST(Polar, OfACubeIsAnOctahedron) {
  const ConvexPolyhedron body(tests::cube_corners(-2, 2));
  const Polar& polar = represent::of<Polar>(body);
  ASSERT_EQ(polar.vertices.size(), 6u);
  for (std::uint32_t f = 0; f < 6; ++f) {
    EXPECT_EQ(part(polar.neighbours, polar.edge_begin, f).size(), 4u);
    const Point3& y = polar.vertices[f];
    const Point3& on_facet = body.vertices()[body.facet(f)[0]];
    double height = 0;
    int zeros = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      height += y[k] * (on_facet[k] - polar.center[k]);
      zeros += y[k] == 0 ? 1 : 0;
    }
    EXPECT_EQ(zeros, 2);
    EXPECT_NEAR(height, 1, 1e-15);
  }
}

TEST(Polar, OfTheEndsOfTheRange) {
  for (const double size :
       {std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(), 1e-200, 1.0}) {
    ASSERT_NO_FATAL_FAILURE(check_polar(ConvexPolyhedron(tests::cube_corners(-size, size)))) << size;
  }
}

TEST(Polar, NeedsAnInterior) {
  for (const std::size_t n : {1u, 2u, 4u}) {
    const std::vector<Point3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const ConvexPolyhedron body(std::vector<Point3>(square.begin(), square.begin() + static_cast<std::ptrdiff_t>(n)));
    try {
      represent::of<Polar>(body);
      FAIL() << "of dimension " << body.dimension();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_shape);
    }
  }
}

// 54 bytes a vertex of the polar where all facets are triangles.
TEST(Polar, Memory) {
  Random random(tests::chosen_seed(20));
  const ConvexPolyhedron body(tests::points_on_sphere(4000, random));
  const double each = static_cast<double>(represent::of<Polar>(body).memory()) / body.facet_count();
  EXPECT_LT(each, 62.5);
  EXPECT_GT(each, 61.5);
}

}  // namespace
}  // namespace sunder::solid
