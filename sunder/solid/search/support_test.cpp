// The floating-point searches against reading every vertex, and what they look at against a bound.
#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/search/support.h>

#include <tests/support/doubles.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sunder::solid {
namespace {

using tests::on_sphere, tests::points_on_sphere;

using tests::infinity, tests::largest, tests::least;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double value(const Point3& d, const Point3& p) { return d.x * p.x + d.y * p.y + d.z * p.z; }

double greatest_value(const SearchGraph& graph, const Point3& d) {
  double best = -infinity;
  for (const Point3& p : graph.vertices) best = std::max(best, value(d, p));
  return best;
}

// Directions at random, along axes and diagonals, and along the facets' normals, where all of a facet ties.
std::vector<Point3> directions_for(const ConvexPolyhedron& body, Random& random, int n) {
  std::vector<Point3> out;
  for (int i = 0; i < n; ++i) out.push_back(on_sphere(random));
  for (int i = 0; i < 27; ++i) out.push_back({i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0});
  const auto v = body.vertices();
  for (std::uint32_t f = 0; f < std::min(body.facet_count(), 50u); ++f) {
    const auto facet = body.facet(f);
    const Point3 &a = v[facet[0]], &b = v[facet[1]], &c = v[facet[2]];
    const Point3 p{b.x - a.x, b.y - a.y, b.z - a.z}, q{c.x - a.x, c.y - a.y, c.z - a.z};
    out.push_back({p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x});
  }
  return out;
}

// A walk may stop early where values tie by rounding; then it is short of the greatest by no more than some roundings.
TEST(SupportTest, FurthestAgainstReadingAll) {
  Random random(43);
  int asked = 0, exactly = 0;
  for (int i = 0; i < 60; ++i) {
    const std::uint32_t n = i < 50 ? static_cast<std::uint32_t>(4 + 2 * i) : static_cast<std::uint32_t>(300 * (i - 49));
    std::vector<Point3> points = points_on_sphere(n, random);
    if (i % 3 == 1) {
      for (Point3& p : points) p = {p.x, p.y * 1e-3, p.z * 1e-6};
    }
    if (i % 3 == 2) {
      for (Point3& p : points) p = {std::round(p.x * 20), std::round(p.y * 20), std::round(p.z * 20)};
    }
    const ConvexPolyhedron body(points);
    const SearchGraph& graph = body.search_graph();
    for (const Point3& d : directions_for(body, random, 100)) {
      std::uint64_t probes = 0;
      const std::uint32_t found = support(body, d, probes);
      ASSERT_LT(found, body.vertices().size());
      ASSERT_GT(probes, 0u);
      const double best = greatest_value(graph, d), here = value(d, graph.vertices[found]);
      const double size = std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z);
      ASSERT_GE(here, best - 0x1p-48 * size * graph.sizes.greatest) << n;
      ++asked;
      exactly += here == best;
    }
  }
  EXPECT_GT(exactly, asked - asked / 100);
}

TEST(SupportTest, OfEqualsTheFirst) {
  std::vector<Point3> points;
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  const ConvexPolyhedron cube(points);
  Random random(3);
  for (const Point3& d : directions_for(cube, random, 100)) {
    std::uint64_t probes = 0;
    const std::uint32_t found = furthest_of_few(cube.search_graph(), d, probes);
    EXPECT_EQ(probes, 8u);
    std::uint32_t first = 0;
    for (std::uint32_t v = 1; v < 8; ++v) {
      if (value(d, cube.vertices()[v]) > value(d, cube.vertices()[first])) first = v;
    }
    EXPECT_EQ(found, first);
  }
}

std::uint32_t whole_walk(const SearchGraph& graph, const Point3& d, std::uint32_t start, std::uint64_t& probes) {
  Walk end{start, false, 0};
  while (!end.has_ended) end = walk(graph, d, end.place, probes);
  return end.place;
}

TEST(SupportTest, AWalkEndsWhereNoNeighbourIsBetter) {
  Random random(47);
  const ConvexPolyhedron body(points_on_sphere(700, random));
  const SearchGraph& graph = body.search_graph();
  for (int i = 0; i < 300; ++i) {
    const Point3 d = on_sphere(random);
    std::uint64_t probes = 0;
    const std::uint32_t start = graph.place[random.below(graph.place.size())];
    const VertexBlock end = graph.block(whole_walk(graph, d, start, probes));
    for (std::uint32_t j = 0; j < end.count(); ++j) {
      ASSERT_LE(value(d, {end.x()[j], end.y()[j], end.z()[j]}), value(d, end.at()));
    }
    ASSERT_EQ(value(d, end.at()), greatest_value(graph, d));
    // From where it ends it goes nowhere, and looks at that vertex and its neighbours.
    probes = 0;
    ASSERT_EQ(graph.block(walk(graph, d, graph.place[end.vertex()], probes).place).vertex(), end.vertex());
    ASSERT_EQ(probes, 1 + end.count());
  }
}

// The cell of a direction is the one it unfolds into: its entry is extreme along a direction not further away than a
// cell is wide.
TEST(SupportTest, TheTableIsReadAtTheDirectionsOwnCell) {
  Random random(53);
  const ConvexPolyhedron body(points_on_sphere(2000, random));
  const SearchGraph& graph = body.search_graph();
  for (std::uint32_t row = 0; row < graph.side; ++row) {
    for (std::uint32_t column = 0; column < graph.side; ++column) {
      // Anywhere inside the cell, at any length.
      const double u = 2 * (column + random.uniform(0.01, 0.99)) / graph.side - 1;
      const double v = 2 * (row + random.uniform(0.01, 0.99)) / graph.side - 1;
      const double over = std::fabs(u) + std::fabs(v) - 1;  // below the upper half's diamond: mirrored in its edge
      const double back = std::max(over, 0.0);
      const double length = std::ldexp(1.0, static_cast<int>(random.between(-1000, 1000)));
      const Point3 d{(u - std::copysign(back, u)) * length, (v - std::copysign(back, v)) * length, -over * length};
      ASSERT_EQ(table_start(graph, d), graph.table[row * graph.side + column]) << u << ' ' << v;
    }
  }
}

TEST(SupportTest, AnyDirectionWillDo) {
  Random random(59);
  for (const std::uint32_t n : {4u, 30u, 100u, 1000u}) {
    const ConvexPolyhedron body(points_on_sphere(n, random));
    const std::vector<double> odd{0.0,  -0.0,    least,    -least,   1e-310,    1.0,
                                  -1.0, largest, -largest, infinity, -infinity, not_a_number};
    for (const double x : odd) {
      for (const double y : odd) {
        for (const double z : odd) {
          std::uint64_t probes = 0;
          ASSERT_LT(support(body, {x, y, z}, probes), body.vertices().size());
          ASSERT_LE(probes, 50 * body.vertices().size());
        }
      }
    }
  }
}

TEST(SupportTest, HugeAndTinyBodies) {
  Random random(61);
  const std::vector<Point3> ball = points_on_sphere(200, random);
  for (const double size : {least, 1e-310, 1e-300, 1e300, largest}) {
    std::vector<Point3> points;
    for (const Point3& p : ball) points.push_back({p.x * size, p.y * size, p.z * size});
    const ConvexPolyhedron body(points);
    for (int i = 0; i < 50; ++i) {
      const Point3 d = on_sphere(random);
      for (const double length : {least, 1.0, largest}) {
        std::uint64_t probes = 0;
        ASSERT_LT(support(body, {d.x * length, d.y * length, d.z * length}, probes), body.vertices().size());
      }
    }
  }
}

// Complexity: on a sphere a table with about a cell a vertex leaves a constant number of steps of about six neighbours
// each, whatever n. Stated bound: 16 probes on average from 64 to 16384 vertices, never more than 64. Bodies of up to
// `few` vertices are read whole.
TEST(SupportTest, ProbesDoNotGrow) {
  Random random(67);
  for (std::uint32_t n = 32; n <= 1u << 14; n *= 2) {
    const ConvexPolyhedron body(points_on_sphere(n, random));
    ASSERT_EQ(body.vertices().size(), n);
    double total = 0;
    std::uint64_t most = 0;
    constexpr int directions = 2000;
    for (int i = 0; i < directions; ++i) {
      std::uint64_t probes = 0;
      support(body, on_sphere(random), probes);
      total += static_cast<double>(probes);
      most = std::max(most, probes);
    }
    RecordProperty("mean_probes_" + std::to_string(n), std::to_string(total / directions));
    EXPECT_LE(total / directions, n <= SearchGraph::few ? n : 16) << n;
    EXPECT_LE(most, 64u) << n;
  }
}

}  // namespace
}  // namespace sunder::solid
