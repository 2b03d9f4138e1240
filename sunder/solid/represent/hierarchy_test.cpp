// A1 to A5 by number, on every family of hard bodies, and the walk down against all vertices.
#include <sunder/base/random.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/hierarchy_walk.h>
#include <sunder/solid/represent/of.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

using tests::on_sphere;

// At most 1.5 times the greatest that was measured at n = 1,000.
constexpr double most_levels = 3;       // times log2 n
constexpr double most_triangles = 7.5;  // times n

using Surface = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;  // of each edge, what is on its left

// The surface of the level with the first m ranks, from the history.
Surface surface(const Hierarchy& h, std::uint32_t m) {
  Surface edges;
  for (std::uint32_t w = 0; w < m; ++w) {
    for (const Hierarchy::Triangle t : h.nodes[w].star()) {
      if (t.beyond < m) continue;
      EXPECT_TRUE(edges.insert({{w, t.a}, t.b}).second);
      EXPECT_TRUE(edges.insert({{t.a, t.b}, w}).second);
      EXPECT_TRUE(edges.insert({{t.b, w}, t.a}).second);
    }
  }
  return edges;
}

// A closed surface on exactly these vertices, no edge of which is reflex: with one of genus 0 it is their hull's.
void check_level(const Hierarchy& h, std::uint32_t m) {
  const Surface edges = surface(h, m);
  ASSERT_EQ(edges.size(), 6 * std::size_t{m} - 12);
  std::vector<bool> seen(m);
  for (const auto& [edge, apex] : edges) {
    const auto twin = edges.find({edge.second, edge.first});
    ASSERT_NE(twin, edges.end());
    ASSERT_LT(apex, m);
    seen[apex] = true;
    ASSERT_NE(orient_3d(h.nodes[edge.first].at, h.nodes[edge.second].at, h.nodes[apex].at, h.nodes[twin->second].at),
              Sign::positive);
  }
  ASSERT_TRUE(std::all_of(seen.begin(), seen.end(), [](bool is) { return is; }));
}

// Is the vertex further than all others along its middle; or are all in or below the plane of the triangle named?
bool is_middle(const Hierarchy& h, std::uint32_t v) {
  const Hierarchy::Node& node = h.nodes[v];
  const WorldDirection direction(node.middle);
  const Affine3 identity;
  Along along(direction, identity, false);
  return std::all_of(h.nodes.begin(), h.nodes.end(), [&](const Hierarchy::Node& other) {
    if (other.at == node.at) return true;
    if (node.has_middle_in_doubles()) return along.compare(other.at, node.at) == Sign::positive;
    const auto& [p, q] = node.middle_triangle;
    return orient_3d(node.at, h.nodes[p].at, h.nodes[q].at, other.at) != Sign::positive;
  });
}

void check_structure(const ConvexPolyhedron& body, const Hierarchy& h, bool all_levels) {
  const std::uint32_t n = static_cast<std::uint32_t>(body.vertices().size());
  // A1, A2 and A3: levels are prefixes of one list of all vertices, from a tetrahedron on.
  ASSERT_EQ(h.level_end.front(), 4u);
  ASSERT_EQ(h.level_end.back(), n);
  std::vector<std::uint32_t> all;
  for (const Hierarchy::Node& node : h.nodes) all.push_back(node.vertex);
  std::sort(all.begin(), all.end());
  for (std::uint32_t v = 0; v < n; ++v) ASSERT_EQ(all[v], v);
  ASSERT_NE(orient_3d(h.nodes[0].at, h.nodes[1].at, h.nodes[2].at, h.nodes[3].at), Sign::zero);
  // A4: those of a level have stars of low degree, of vertices of the level above.
  for (std::size_t i = 1; i < h.level_end.size(); ++i) {
    ASSERT_LT(h.level_end[i - 1], h.level_end[i]);
    for (std::uint32_t w = h.level_end[i - 1]; w < h.level_end[i]; ++w) {
      ASSERT_EQ(h.nodes[w].at, body.vertices()[h.nodes[w].vertex]);
      ASSERT_GE(h.nodes[w].star().size(), 3u);
      ASSERT_LE(h.nodes[w].star().size(), Hierarchy::most_degree);
      for (std::size_t k = 0; k < h.nodes[w].star().size(); ++k) {
        ASSERT_LT(h.nodes[w].star()[k].a, h.level_end[i - 1]);
        ASSERT_EQ(h.nodes[w].star()[k].b, h.nodes[w].star()[(k + 1) % h.nodes[w].star().size()].a);
      }
    }
  }
  if (all_levels) {
    for (std::uint32_t v = 0; v < n; ++v) ASSERT_TRUE(is_middle(h, v)) << v;
    for (const std::uint32_t m : h.level_end) ASSERT_NO_FATAL_FAILURE(check_level(h, m));
  }
}

// Bodies of so many vertices are for whole runs of the tests; of a million, for ./do soak.
bool is_asked_for(std::size_t n) {
  return n <= 1000 || tests::scaled_count(1000) >= (n <= 20000 ? 50 : n < 1000000 ? 1000 : 20000);
}

std::size_t triangle_count(const Hierarchy& h) {
  std::size_t count = 0;
  for (const Hierarchy::Node& node : h.nodes) count += node.size;
  return count;
}

TEST(HierarchyTest, StructureOfEveryFamily) {
  Random random(tests::chosen_seed(71));
  for (const std::size_t n : {12u, 100u, 1000u, 20000u, 131072u, 1000000u}) {
    if (!is_asked_for(n)) continue;
    double levels = 0, triangles = 0;
    for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
      if (shape.name == "flat") continue;
      SCOPED_TRACE(shape.name);
      const ConvexPolyhedron body(shape.make(n, random));
      const double size = static_cast<double>(body.vertices().size());
      if (size < 4) continue;
      const Hierarchy& h = represent::of<Hierarchy>(body);
      ASSERT_NO_FATAL_FAILURE(check_structure(body, h, n <= (tests::is_scaled_down() ? 100u : 1000u))) << n;
      levels = std::max(levels, static_cast<double>(h.level_end.size()) / std::log2(size));
      const double made = static_cast<double>(triangle_count(h));
      triangles = std::max(triangles, made / size);
      if (n >= 131072) {
        std::printf("%-14.*s %7.0f vertices, %3zu levels, %5.2f triangles and %4.0f bytes a vertex\n",
                    static_cast<int>(shape.name.size()), shape.name.data(), size, h.level_end.size(), made / size,
                    static_cast<double>(h.memory()) / size);
      }
    }
    std::printf("n = %zu: at most %.2f log2 n levels, %.2f n triangles\n", n, levels, triangles);
    EXPECT_LE(levels, most_levels) << n;
    EXPECT_LE(triangles, most_triangles) << n;
  }
}

struct Asked {
  std::uint32_t vertex = 0;
  std::uint64_t probes = 0;
};

Asked extreme(const Hierarchy& h, const Point3& d) {
  const WorldDirection direction(d);
  const Affine3 identity;
  Along along(direction, identity, false);
  const auto at = [&](std::uint32_t rank) { return h.nodes[rank].at; };
  const auto compare = [&](std::uint32_t i, std::uint32_t j) { return along.compare(at(i), at(j)); };
  const auto turn = [&](std::uint32_t v, std::uint32_t i, std::uint32_t j) {
    const Hierarchy::Node& node = h.nodes[v];
    if (node.has_middle_in_doubles()) return along.turn(node.middle, node.at, at(i), at(j), false);
    const auto& [p, q] = node.middle_triangle;
    return along.turn_about_normal(at(p), at(q), node.at, at(i), at(j));
  };
  Asked asked;
  asked.vertex = h.nodes[HierarchyWalk(h, compare, turn, asked.probes).run()].vertex;
  return asked;
}

Asked extreme(const ConvexPolyhedron& body, const Point3& d) { return extreme(represent::of<Hierarchy>(body), d); }

bool is_extreme(const ConvexPolyhedron& body, const Point3& d, std::uint32_t v) {
  const WorldDirection direction(d);
  const Affine3 identity;
  Along along(direction, identity, true);
  return std::all_of(body.vertices().begin(), body.vertices().end(),
                     [&](const Point3& p) { return along.compare(body.vertices()[v], p) != Sign::positive; });
}

// Directions that tie: axes, and small whole numbers, which are normals of grids.
Point3 some_direction(Random& random, int i) {
  if (i % 3 == 0) return on_sphere(random);
  const auto part = [&] { return static_cast<double>(random.below(5)) - 2; };
  if (i % 3 == 1) return {part(), part(), part()};
  const Point3 d{part(), part(), part()};
  return {d.x + std::ldexp(1.0, -50) * part(), d.y, d.z + std::ldexp(1.0, -52) * part()};
}

TEST(HierarchyTest, TheWalkEndsAtAnExtremeVertex) {
  Random random(tests::chosen_seed(73));
  for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
    SCOPED_TRACE(shape.name);
    for (const std::size_t n : {8u, 20u, 100u, 1000u}) {
      const ConvexPolyhedron body(shape.make(n, random));
      if (body.dimension() < 2) continue;
      const int times = tests::scaled_count(n < 1000 ? 150 : 60);
      for (int i = 0; i < times; ++i) {
        const Point3 d = some_direction(random, i);
        ASSERT_TRUE(is_extreme(body, d, extreme(body, d).vertex)) << n << ' ' << d.x << ' ' << d.y << ' ' << d.z;
      }
    }
  }
}

// Whole coordinates in a small cube: facets of many coplanar vertices, and directions along their normals.
TEST(HierarchyTest, OfWholeNumbers) {
  Random random(tests::chosen_seed(79));
  const int bodies = tests::scaled_count(300);
  for (int i = 0; i < bodies; ++i) {
    const std::uint64_t side = 3 + random.below(12);
    std::vector<Point3> points;
    const auto part = [&] { return static_cast<double>(random.below(side)); };
    for (std::uint64_t k = 10 + random.below(200); k > 0; --k) points.push_back({part(), part(), part()});
    const ConvexPolyhedron body(points);
    if (body.dimension() < 2) continue;
    if (body.dimension() == 3) {
      ASSERT_NO_FATAL_FAILURE(check_structure(body, represent::of<Hierarchy>(body), true));
    }
    for (std::uint32_t f = 0; f < std::min(body.facet_count(), 20u); ++f) {
      const auto facet = body.facet(f);
      const Point3 &a = body.vertices()[facet[0]], &b = body.vertices()[facet[1]], &c = body.vertices()[facet[2]];
      const Point3 p{b.x - a.x, b.y - a.y, b.z - a.z}, q{c.x - a.x, c.y - a.y, c.z - a.z};
      const Point3 normal{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
      for (const Point3& d :
           {normal, Point3{-normal.x, -normal.y, -normal.z}, Point3{b.x - a.x, b.y - a.y, b.z - a.z}}) {
        ASSERT_TRUE(is_extreme(body, d, extreme(body, d).vertex)) << i;
      }
    }
    for (int k = 0; k < 30; ++k) {
      const Point3 d = some_direction(random, 1);
      ASSERT_TRUE(is_extreme(body, d, extreme(body, d).vertex)) << i << ' ' << d.x << ' ' << d.y << ' ' << d.z;
    }
  }
}

// All permutations of three numbers, with all signs: middles of cones lie in planes of symmetry, and so do directions,
// so that signs vanish together.
TEST(HierarchyTest, OfSymmetricBodies) {
  Random random(tests::chosen_seed(89));
  for (int i = tests::scaled_count(60, 15); i > 0; --i) {
    std::vector<Point3> points;
    for (std::uint64_t k = 1 + random.below(4); k > 0; --k) {
      std::array<double, 3> c;
      for (double& x : c) x = static_cast<double>(random.below(6));
      std::sort(c.begin(), c.end());
      do {
        for (int signs = 0; signs < 8; ++signs) {
          points.push_back({signs & 1 ? -c[0] : c[0], signs & 2 ? -c[1] : c[1], signs & 4 ? -c[2] : c[2]});
        }
      } while (std::next_permutation(c.begin(), c.end()));
    }
    const ConvexPolyhedron body(points);
    if (body.dimension() < 3) continue;
    ASSERT_NO_FATAL_FAILURE(check_structure(body, represent::of<Hierarchy>(body), true));
    for (int x = -3; x <= 3; ++x) {
      for (int y = -3; y <= 3; ++y) {
        for (int z = -3; z <= 3; ++z) {
          const Point3 d{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          ASSERT_TRUE(is_extreme(body, d, extreme(body, d).vertex)) << i << ' ' << x << ' ' << y << ' ' << z;
        }
      }
    }
  }
}

// Normals here are so far apart that no mean of them in doubles is one of the cone.
TEST(HierarchyTest, MiddlesOfNeedles) {
  Random random(tests::chosen_seed(97));
  std::vector<Point3> points = tests::points_on_sphere(200, random);
  for (Point3& p : points) p = {p.x * 0x1p80, p.y, p.z * 0x1p-80};
  const ConvexPolyhedron body(points);
  const Hierarchy& h = represent::of<Hierarchy>(body);
  ASSERT_NO_FATAL_FAILURE(check_structure(body, h, true));
  EXPECT_FALSE(std::all_of(h.nodes.begin(), h.nodes.end(),
                           [](const Hierarchy::Node& node) { return node.has_middle_in_doubles(); }));
}

// Any triangle of P's surface at a vertex is as good a middle as that which was chosen.
Hierarchy with_triangles_as_middles(Hierarchy h, Random& random) {
  std::vector<std::vector<std::array<std::uint32_t, 2>>> around(h.nodes.size());
  for (const auto& [edge, left] : surface(h, static_cast<std::uint32_t>(h.nodes.size()))) {
    around[edge.first].push_back({edge.second, left});
  }
  for (std::size_t v = 0; v < h.nodes.size(); ++v)
    h.nodes[v].middle_triangle = around[v][random.below(around[v].size())];
  return h;
}

// Where a new corner of a cone is its middle, every sign about it is zero, and the walk has to keep the neighbour that
// it has (W3): with normals of triangles as middles, and directions along which edges and facets tie.
TEST(HierarchyTest, TiesAboutMiddlesThatAreCorners) {
  Random random(tests::chosen_seed(101));
  const int bodies = tests::scaled_count(300);
  for (int i = 0; i < bodies; ++i) {
    std::vector<Point3> points;
    const auto part = [&] { return static_cast<double>(random.between(-4, 4)); };
    for (std::uint64_t k = 10 + random.below(60); k > 0; --k) points.push_back({part(), part(), part()});
    const ConvexPolyhedron body(points);
    if (body.dimension() < 3) continue;
    const Hierarchy h = with_triangles_as_middles(represent::of<Hierarchy>(body), random);
    for (int k = 0; k < 300; ++k) {
      const Point3 d{part(), part(), part()};
      ASSERT_TRUE(is_extreme(body, d, extreme(h, d).vertex)) << i << ' ' << d.x << ' ' << d.y << ' ' << d.z;
    }
  }
}

TEST(HierarchyTest, ProbesGrowAsTheLogarithm) {
  Random random(tests::chosen_seed(83));
  constexpr double most_probes = 4.2;  // times log2 n: 1.5 times the greatest at n = 1,000
  for (const std::size_t n : {1000u, 16384u, 131072u}) {
    if (!is_asked_for(n)) continue;
    double worst = 0;
    for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
      const ConvexPolyhedron body(shape.make(n, random));
      for (int i = 0; i < 60; ++i) {
        const double probes = static_cast<double>(extreme(body, some_direction(random, i)).probes);
        worst = std::max(worst, probes / std::log2(std::max<std::size_t>(body.vertices().size(), 8)));
      }
    }
    std::printf("n = %zu: at most %.2f log2 n probes\n", n, worst);
    EXPECT_LE(worst, most_probes) << n;
  }
}

}  // namespace
}  // namespace sunder::solid
