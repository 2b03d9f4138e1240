// The layout: every number in a block is the vertex' own, every entry of the table extreme, every size right.
#include <sunder/base/random.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/search_graph.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace sunder::solid {
namespace {

using tests::largest, tests::least;

// On a sphere, rounded to multiples of 2^-20: in convex position up to a few.
std::vector<Point3> sphere(Random& random, std::size_t n) {
  std::vector<Point3> points = tests::points_on_sphere(n, random);
  for (Point3& p : points) p = {tests::snapped(p.x, 20), tests::snapped(p.y, 20), tests::snapped(p.z, 20)};
  return points;
}

std::vector<Point3> circle(int n) {
  std::vector<Point3> points;
  for (int i = 0; i < n; ++i) {
    const double t = 6.283185307179586 * i / n;
    points.push_back({std::cos(t), std::sin(t), 0});
  }
  return points;
}

void expect_layout(const ConvexPolyhedron& body) {
  const SearchGraph& graph = body.search_graph();
  const std::uint32_t n = static_cast<std::uint32_t>(body.vertices().size());
  ASSERT_EQ(graph.vertices.size(), n);
  ASSERT_EQ(graph.begin.size(), n + 1);
  ASSERT_EQ(graph.place.size(), n);
  std::set<std::uint32_t> places(graph.place.begin(), graph.place.end());
  ASSERT_EQ(places.size(), n);
  std::size_t words = 0;
  for (std::uint32_t v = 0; v < n; ++v) {
    const VertexBlock block = graph.block(graph.place[v]);
    const auto neighbours = body.neighbours(v);
    ASSERT_EQ(block.vertex(), v);
    ASSERT_EQ(block.at(), body.vertices()[v]);
    ASSERT_EQ(block.count(), neighbours.size());
    for (std::uint32_t j = 0; j < block.count(); ++j) {
      ASSERT_EQ(block.place(j), graph.place[neighbours[j]]);
      ASSERT_EQ(graph.block(block.place(j)).vertex(), neighbours[j]);
      ASSERT_EQ((Point3{block.x()[j], block.y()[j], block.z()[j]}), body.vertices()[neighbours[j]]);
      const auto back = body.neighbours(neighbours[j]);
      ASSERT_NE(std::find(back.begin(), back.end(), v), back.end());
    }
    ASSERT_EQ(block.padded(), (neighbours.size() + 3) / 4 * 4);
    for (std::uint32_t j = block.count(); j < block.padded(); ++j) {
      ASSERT_EQ(block.place(j), block.place(0));
      ASSERT_EQ((Point3{block.x()[j], block.y()[j], block.z()[j]}), body.vertices()[neighbours[0]]);
    }
    words += 4 + 3 * block.padded() + block.padded() / 2;
    ASSERT_EQ(v + 1 < n ? graph.place[v + 1] : graph.blocks.size() - VertexBlock::words_ahead, words);
  }

  SizeRange sizes;
  for (const Point3& p : body.vertices()) {
    for (const double x : {p.x, p.y, p.z}) sizes.include(x);
    ASSERT_TRUE(graph.low.x <= p.x && graph.low.y <= p.y && graph.low.z <= p.z);
    ASSERT_TRUE(graph.high.x >= p.x && graph.high.y >= p.y && graph.high.z >= p.z);
  }
  ASSERT_EQ(graph.sizes.least, sizes.least);
  ASSERT_EQ(graph.sizes.greatest, sizes.greatest);
  ASSERT_TRUE(graph.low.x <= graph.middle.x && graph.middle.x <= graph.high.x);
  ASSERT_TRUE(graph.low.y <= graph.middle.y && graph.middle.y <= graph.high.y);
  ASSERT_TRUE(graph.low.z <= graph.middle.z && graph.middle.z <= graph.high.z);

  if (n <= SearchGraph::few) {
    ASSERT_TRUE(graph.table.empty());
    ASSERT_EQ(graph.padded, (n + 3) / 4 * 4);
    ASSERT_EQ(graph.all.size(), 3 * graph.padded);
    for (std::uint32_t i = 0; i < graph.padded; ++i) {
      const Point3& p = body.vertices()[i < n ? i : 0];
      ASSERT_EQ((Point3{graph.all[i], graph.all[graph.padded + i], graph.all[2 * graph.padded + i]}), p);
    }
  } else {
    ASSERT_EQ(graph.padded, 0u);
    ASSERT_TRUE(graph.all.empty());
    if (graph.is_slow) {
      ASSERT_TRUE(graph.table.empty());
      return;
    }
    ASSERT_GT(graph.side, 0u);
    ASSERT_EQ(graph.table.size(), std::size_t{graph.side} * graph.side);
    ASSERT_LE(graph.table.size(), 10 * n) << "the table takes about an eighth of the memory";
    for (const std::uint32_t place : graph.table) ASSERT_EQ(places.count(place), 1u);
  }
}

// The point of the octahedron |x| + |y| + |z| = 1 that the header unfolds to (u, v): beyond an edge of the upper half's
// diamond, the mirror image in that edge is what lies below.
Point3 on_octahedron(double u, double v) {
  const double sign_u = u < 0 ? -1 : 1, sign_v = v < 0 ? -1 : 1;
  const double over = std::fabs(u) + std::fabs(v) - 1;
  if (over <= 0) return {u, v, -over};
  return {u - over * sign_u, v - over * sign_v, -over};
}

// How many entries of the table are not extreme, exactly, along the direction to the middle of their cell.
int count_wrong_entries(const ConvexPolyhedron& body) {
  const SearchGraph& graph = body.search_graph();
  int wrong = 0;
  for (std::uint32_t i = 0; i < graph.table.size(); ++i) {
    const std::uint32_t row = i / graph.side, column = i % graph.side;
    const double u = (2.0 * column + 1) / graph.side - 1, v = (2.0 * row + 1) / graph.side - 1;
    const WorldDirection direction(on_octahedron(u, v));
    const Affine3 at_home;
    Along along(direction, at_home, false);
    const Point3 entry = graph.block(graph.table[i]).at();
    for (const Point3& p : body.vertices()) {
      if (along.compare(entry, p) == Sign::positive) {
        ++wrong;
        break;
      }
    }
  }
  return wrong;
}

TEST(SearchGraphTest, BodiesOfAllSizes) {
  Random random(29);
  for (const std::size_t n : {4u, 5u, 7u, 8u, 31u, 32u, 33u, 34u, 60u, 200u, 1000u}) {
    if (n > 200 && tests::is_scaled_down()) continue;
    const ConvexPolyhedron body(sphere(random, n));
    ASSERT_NO_FATAL_FAILURE(expect_layout(body)) << n;
    // In doubles of such coordinates next to no ties are lost.
    EXPECT_LE(count_wrong_entries(body), static_cast<int>(body.search_graph().table.size()) / 100) << n;
  }
}

TEST(SearchGraphTest, FewAndManyMeetWhereTheHeaderSays) {
  const ConvexPolyhedron few(circle(SearchGraph::few)), many(circle(SearchGraph::few + 1));
  ASSERT_EQ(few.vertices().size(), SearchGraph::few);
  ASSERT_EQ(many.vertices().size(), SearchGraph::few + 1);
  EXPECT_EQ(few.search_graph().padded, SearchGraph::few);
  EXPECT_EQ(many.search_graph().padded, 0u);
}

TEST(SearchGraphTest, FlatAndNeedleLikeBodies) {
  Random random(31);
  ASSERT_NO_FATAL_FAILURE(expect_layout(ConvexPolyhedron(std::vector<Point3>{{1, 2, 3}})));
  ASSERT_NO_FATAL_FAILURE(expect_layout(ConvexPolyhedron(std::vector<Point3>{{0, 0, 0}})));
  ASSERT_NO_FATAL_FAILURE(expect_layout(ConvexPolyhedron(std::vector<Point3>{{1, 2, 3}, {-1, 0, 0}})));
  for (const int n : {3, 32, 33, 500}) {
    const ConvexPolyhedron polygon(circle(n));
    ASSERT_EQ(polygon.dimension(), 2);
    ASSERT_NO_FATAL_FAILURE(expect_layout(polygon)) << n;
    EXPECT_LE(count_wrong_entries(polygon), static_cast<int>(polygon.search_graph().table.size()) / 50) << n;
  }
  // A prism whose top and bottom have a high degree of ties, a double cone with two vertices of high degree, a needle.
  for (const double height : {1.0, 1e-9, 1e9}) {
    std::vector<Point3> prism, cone;
    for (const Point3& p : circle(100)) {
      prism.push_back({p.x, p.y, height});
      prism.push_back({p.x, p.y, -height});
      cone.push_back(p);
    }
    cone.push_back({0, 0, height});
    cone.push_back({0, 0, -height});
    for (const std::vector<Point3>* given : {&prism, &cone}) {
      const std::vector<Point3>& points = *given;
      const ConvexPolyhedron body(points);
      ASSERT_NO_FATAL_FAILURE(expect_layout(body)) << height;
      EXPECT_EQ(body.search_graph().is_slow, &points == &cone) << height;
      EXPECT_LE(count_wrong_entries(body), static_cast<int>(body.search_graph().table.size()) / 10) << height;
    }
  }
}

// Values along directions overflow or vanish here: entries need not be extreme, but they must be vertices.
TEST(SearchGraphTest, TheEndsOfTheRangeOfDoubles) {
  Random random(37);
  const ConvexPolyhedron ball(sphere(random, 100));
  for (const double size : {least, 1e-310, 1e-300, 1e300, largest}) {
    std::vector<Point3> points;
    for (const Point3& p : ball.vertices()) points.push_back({p.x * size, p.y * size, p.z * size});
    ASSERT_NO_FATAL_FAILURE(expect_layout(ConvexPolyhedron(points))) << size;
  }
  std::vector<Point3> corner;
  for (const Point3& p : ball.vertices()) corner.push_back({largest - 1e299 * (1 + p.x), 1e299 * p.y, p.z * 1e299});
  ASSERT_NO_FATAL_FAILURE(expect_layout(ConvexPolyhedron(corner)));
}

}  // namespace
}  // namespace sunder::solid
