// The hierarchy of the polar: its structure by exact signs of polar vertices, and what a walk down it finds against all
// facets.
#include <sunder/base/error.h>
#include <sunder/number/vector.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/hierarchy_walk.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/represent/polar.h>
#include <sunder/solid/represent/polar_hierarchy.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace sunder::solid {
namespace {

using tests::SolidShape;

// At most 1.5 times the greatest that was measured at n = 1,000.
constexpr double most_polar_levels = 3;       // times log2 of the facets
constexpr double most_polar_triangles = 7.5;  // times the facets

// The polar's vertices, exactly.
class Exact {
 public:
  explicit Exact(const ConvexPolyhedron& body) {
    const PolarHierarchy& polar = represent::of<PolarHierarchy>(body);
    for (const Hierarchy::Node& node : polar.hierarchy.nodes) {
      rows_.push_back(exact_polar_vertex(body.vertices(), body.facet(node.vertex), polar.base));
    }
  }
  // Of ranks: on which side of the triangle a, b, c is d? Positive: outside, where these are counter-clockwise.
  Sign side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return dot(cross(edge(a, b), edge(a, c)), edge(a, d)).sign();
  }

 private:
  Vector3<Dyadic> edge(std::uint32_t from, std::uint32_t to) const {  // times a positive number
    const PolarVertex &p = rows_[from], &q = rows_[to];
    const auto part = [&](std::size_t k) { return q.n[k] * p.h - p.n[k] * q.h; };
    return {part(0), part(1), part(2)};
  }
  std::vector<PolarVertex> rows_;
};

void check_polar_level(const Hierarchy& h, const Exact& exact, std::uint32_t m) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> apex;  // of each edge, what is on its left
  for (std::uint32_t w = 0; w < m; ++w) {
    for (const Hierarchy::Triangle t : h.nodes[w].star()) {
      if (t.beyond < m) continue;
      ASSERT_TRUE(apex.insert({{w, t.a}, t.b}).second);
      ASSERT_TRUE(apex.insert({{t.a, t.b}, w}).second);
      ASSERT_TRUE(apex.insert({{t.b, w}, t.a}).second);
    }
  }
  ASSERT_EQ(apex.size(), 6 * std::size_t{m} - 12);
  for (const auto& [edge, left] : apex) {
    const auto right = apex.find({edge.second, edge.first});
    ASSERT_NE(right, apex.end());
    ASSERT_NE(exact.side(edge.first, edge.second, left, right->second), Sign::positive);
  }
}

void check(const ConvexPolyhedron& body, std::string_view name, bool all_levels) {
  const Hierarchy& h = represent::of<PolarHierarchy>(body).hierarchy;
  const std::uint32_t n = body.facet_count();
  ASSERT_EQ(h.level_end.front(), 4u);
  ASSERT_EQ(h.level_end.back(), n);
  std::vector<std::uint32_t> all;
  for (const Hierarchy::Node& node : h.nodes) all.push_back(node.vertex);
  std::sort(all.begin(), all.end());
  for (std::uint32_t f = 0; f < n; ++f) ASSERT_EQ(all[f], f);
  std::size_t triangles = 0;
  for (std::size_t i = 1; i < h.level_end.size(); ++i) {
    ASSERT_LT(h.level_end[i - 1], h.level_end[i]);
    for (std::uint32_t w = h.level_end[i - 1]; w < h.level_end[i]; ++w) {
      const Hierarchy::Star star = h.nodes[w].star();
      triangles += star.size();
      ASSERT_GE(star.size(), 3u);
      ASSERT_LE(star.size(), Hierarchy::most_degree);
      for (const Hierarchy::Triangle t : star) ASSERT_LT(t.a, h.level_end[i - 1]);  // independent of its own level
    }
  }
  const double levels = static_cast<double>(h.level_end.size()) / std::log2(n),
               each = static_cast<double>(triangles) / n;
  EXPECT_LE(levels, most_polar_levels) << name;
  EXPECT_LE(each, most_polar_triangles) << name;
  if (!all_levels) {
    std::printf("%-13.*s %7u facets: %zu levels (%.2f log2), %.2f triangles each\n", static_cast<int>(name.size()),
                name.data(), n, h.level_end.size(), levels, each);
    return;
  }
  const Exact exact(body);
  for (const std::uint32_t m : h.level_end) ASSERT_NO_FATAL_FAILURE(check_polar_level(h, exact, m)) << name << " " << m;
}

TEST(PolarHierarchy, EveryLevelIsConvex) {
  Random random(tests::chosen_seed(31));
  for (const SolidShape& shape : tests::all_solid_shapes()) {
    for (const std::size_t n : {8u, 20u, 100u, 300u}) {
      const ConvexPolyhedron body(shape.make(n, random));
      if (body.dimension() != 3) continue;
      ASSERT_NO_FATAL_FAILURE(check(body, shape.name, true)) << n;
    }
  }
  for (int i = 0; i < tests::scaled_count(100); ++i) {  // of small whole numbers: many planes through one point
    std::vector<Point3> points;
    const auto coordinate = [&] { return static_cast<double>(random.between(-3, 3)); };
    for (int k = 0; k < 12; ++k) points.push_back({coordinate(), coordinate(), coordinate()});
    const ConvexPolyhedron body(points);
    if (body.dimension() != 3) continue;
    ASSERT_NO_FATAL_FAILURE(check(body, "whole numbers", true)) << i;
  }
}

// Numbers of very different sizes along one axis: to bring the body near 1 there would round some of them to zero, and
// what is left is another body, with facets through its inside.
TEST(PolarHierarchy, OfCoordinatesThatWouldUnderflow) {
  const std::vector<Point3> seen{{-0x1.d8bdd68b5ebp+756, 0x1.c4c041811ff3p-3, 0},
                                 {-0x1.2321f3fe11908p-762, -0x1.501402898f3eap-1, 0x1.9d87cec6f883p-761},
                                 {0, 0, 0},
                                 {-0x1.7e3e845adba6p-2, 0x1.f09619a1a74p-766, 0},
                                 {0x1.6f5108c4d1f16p+758, 0, -0x1.46efc3838bp-768},
                                 {-0x1.59a0c9b421a4cp+757, -0x1.a2639156fc54p+753, 0x1.35224648dc714p+757}};
  ASSERT_NO_FATAL_FAILURE(check(ConvexPolyhedron(seen), "seen to hang", true));
  Random random(tests::chosen_seed(35));
  int bodies = 0;
  for (int i = 0; i < tests::scaled_count(200); ++i) {
    const int power = static_cast<int>(random.between(400, 1000));
    const auto coordinate = [&] {
      const double x = random.uniform(-1, 1);
      const std::array<double, 4> some{0, x, std::ldexp(x, power), std::ldexp(x, -power)};
      return some[random.below(4)];
    };
    std::vector<Point3> points;
    for (int k = 0; k < 9; ++k) points.push_back({coordinate(), coordinate(), coordinate()});
    const ConvexPolyhedron body(points);
    if (body.dimension() != 3) continue;
    ++bodies;
    ASSERT_NO_FATAL_FAILURE(check(body, "far apart", true)) << i;
  }
  EXPECT_GT(bodies, tests::scaled_count(200) / 2);
}

// Thin along no axis: its frame is round, and the signs are those of the body.
TEST(PolarHierarchy, OfPlatesAndNeedlesAlongNoAxis) {
  Random random(tests::chosen_seed(36));
  for (int i = 0; i < tests::scaled_count(60); ++i) {
    const double thin = random.log_uniform(1e-13, 1e-3), wide = random.below(2) == 0 ? 1 : thin;
    const Point3 u = tests::on_sphere(random), w = tests::on_sphere(random);
    const Vector3<double> x{u.x, u.y, u.z}, y = cross(x, Vector3<double>{w.x, w.y, w.z}), z = cross(x, y);
    std::vector<Point3> points = tests::points_on_sphere(40, random);
    for (Point3& p : points) {
      const double b = p.y * wide, c = p.z * thin;
      p = {p.x * x.x + b * y.x + c * z.x, p.x * x.y + b * y.y + c * z.y, p.x * x.z + b * y.z + c * z.z};
    }
    const ConvexPolyhedron body(points);
    ASSERT_NO_FATAL_FAILURE(check(body, "thin", true)) << i;
    const PolarHierarchy& polar = represent::of<PolarHierarchy>(body);
    ASSERT_FALSE(polar.to_round.is_identity) << i << ' ' << thin;
    for (const Hierarchy::Node& node : polar.hierarchy.nodes) {
      const auto size = [](const Point3& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); };
      ASSERT_LT(size(node.middle), 2) << i;
      ASSERT_GT(size(node.middle), 0x1p-8) << i;
      ASSERT_NEAR(node.at.x * node.middle.x + node.at.y * node.middle.y + node.at.z * node.middle.z, 1, 0.5) << i;
    }
  }
  EXPECT_TRUE(PolarHierarchy::make(ConvexPolyhedron(tests::points_on_sphere(40, random))).to_round.is_identity);
}

TEST(PolarHierarchy, SizeAndDepth) {
  Random random(tests::chosen_seed(32));
  for (const SolidShape& shape : tests::all_solid_shapes()) {
    for (const std::size_t n : {1000u, 10000u, 131072u, 1000000u}) {
      // For whole runs of the tests; of a million, for ./do soak.
      if (n > 1000 && tests::scaled_count(50) < (n < 20000 ? 5 : n < 1000000 ? 50 : 1000)) continue;
      const ConvexPolyhedron body(shape.make(n, random));
      if (body.dimension() != 3) continue;
      ASSERT_NO_FATAL_FAILURE(check(body, shape.name, false));
    }
  }
}

// The facet that a ray from o leaves the body through. Where facets are nearly coplanar, doubles may take the wrong
// turn between them.
TEST(PolarHierarchy, AWalkFindsTheFacetOfARay) {
  Random random(tests::chosen_seed(33));
  for (const SolidShape& shape : tests::all_solid_shapes()) {
    const ConvexPolyhedron body(shape.make(500, random));
    if (body.dimension() != 3) continue;
    int found_it = 0;
    const Hierarchy& h = represent::of<PolarHierarchy>(body).hierarchy;
    for (int i = 0; i < 100; ++i) {
      const Point3 y = tests::on_sphere(random);
      const auto along = [&](const Point3& p) { return p.x * y.x + p.y * y.y + p.z * y.z; };
      const auto from_to = [&](std::uint32_t v, std::uint32_t w) {
        const Point3 &p = h.nodes[v].at, &q = h.nodes[w].at;
        return Point3{q.x - p.x, q.y - p.y, q.z - p.z};
      };
      const auto sign = [](double x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; };
      const auto compare = [&](std::uint32_t v, std::uint32_t w) { return sign(along(from_to(v, w))); };
      const auto turn = [&](std::uint32_t v, std::uint32_t p, std::uint32_t q) {
        const Point3 &m = h.nodes[v].middle, a = from_to(v, p), b = from_to(v, q);
        const auto middle = [&](const Point3& e) { return e.x * m.x + e.y * m.y + e.z * m.z; };
        return sign(along(a) * middle(b) - along(b) * middle(a));
      };
      std::uint64_t probes = 0;
      const std::uint32_t found = HierarchyWalk(h, compare, turn, probes).run();
      double best = 0;
      for (const Hierarchy::Node& node : h.nodes) best = std::max(best, along(node.at));
      found_it += along(h.nodes[found].at) >= best * (1 - 0x1p-40);
      EXPECT_LE(static_cast<double>(probes), 8 * std::log2(h.nodes.size())) << shape.name;
    }
    EXPECT_GE(found_it, shape.name == "saddle" || shape.name == "chain" ? 90 : 100) << shape.name;
  }
}

// The body with both of its hierarchies.
TEST(PolarHierarchy, ABodyTakesAtMostAThousandBytesAVertex) {
  Random random(tests::chosen_seed(34));
  for (const SolidShape& shape : tests::all_solid_shapes()) {
    const ConvexPolyhedron body(shape.make(static_cast<std::size_t>(tests::scaled_count(20000, 4000)), random));
    const std::size_t n = body.vertices().size();
    if (n < 1000) continue;  // the grid
    std::size_t bytes = body.memory() + represent::of<Hierarchy>(body).memory();
    if (body.dimension() == 3) bytes += represent::of<PolarHierarchy>(body).hierarchy.memory();
    const double each = static_cast<double>(bytes) / static_cast<double>(n);
    std::printf("%-13.*s %6zu vertices, %6.0f bytes each\n", static_cast<int>(shape.name.size()), shape.name.data(), n,
                each);
    EXPECT_LE(each, 1000) << shape.name;
  }
}

TEST(PolarHierarchy, NeedsAnInterior) {
  const ConvexPolyhedron triangle(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_THROW(represent::of<PolarHierarchy>(triangle), Error);
}

}  // namespace
}  // namespace sunder::solid
