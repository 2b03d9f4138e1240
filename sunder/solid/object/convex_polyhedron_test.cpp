// The object against the hull that it is made of: the same vertices, facets and edges under other numbers.
#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/search_graph.h>

#include <tests/support/doubles.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

using tests::largest, tests::least;

using Cycle = std::vector<std::uint32_t>;

// A cycle of points of the input, beginning with the lowest.
template <class Numbers, class Source>
Cycle cycle(const Numbers& numbers, const Source& source) {
  Cycle out;
  for (const std::uint32_t v : numbers) out.push_back(source[v]);
  if (!out.empty()) std::rotate(out.begin(), std::min_element(out.begin(), out.end()), out.end());
  return out;
}

void expect_hull(const std::vector<Point3>& points) {
  const ConvexPolyhedron body(points);
  const ConvexHull hull = convex_hull(points);
  const std::size_t n = hull.vertices.size();
  ASSERT_EQ(body.dimension(), hull.dimension);
  ASSERT_EQ(body.vertices().size(), n);
  ASSERT_EQ(body.source().size(), n);
  std::vector<std::uint32_t> source(body.source().begin(), body.source().end());
  for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(body.vertices()[i], points[source[i]]) << i;
  std::sort(source.begin(), source.end());
  ASSERT_EQ(source, hull.vertices);

  // Around each vertex, the same cycle.
  std::set<std::pair<std::uint32_t, Cycle>> around, around_hull;
  for (std::uint32_t v = 0; v < n; ++v) {
    around.insert({body.source()[v], cycle(body.neighbours(v), body.source())});
    const std::span<const std::uint32_t> numbers(hull.neighbours.data() + hull.neighbour_begin[v],
                                                 hull.neighbour_begin[v + 1] - hull.neighbour_begin[v]);
    around_hull.insert({hull.vertices[v], cycle(numbers, hull.vertices)});
  }
  ASSERT_EQ(around, around_hull);

  std::set<Cycle> facets, facets_of_hull;
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) facets.insert(cycle(body.facet(f), body.source()));
  for (std::size_t f = 0; f + 1 < hull.facet_begin.size(); ++f) {
    const std::span<const std::uint32_t> numbers(hull.facet_vertices.data() + hull.facet_begin[f],
                                                 hull.facet_begin[f + 1] - hull.facet_begin[f]);
    facets_of_hull.insert(cycle(numbers, hull.vertices));
  }
  ASSERT_EQ(facets, facets_of_hull);
  ASSERT_EQ(facets.size(), body.facet_count());

  const auto [low, high] = body.box();
  const auto range = [&](double Point3::* member) {
    const auto [first, last] = std::minmax_element(
        points.begin(), points.end(), [&](const Point3& p, const Point3& q) { return p.*member < q.*member; });
    return std::pair{(*first).*member, (*last).*member};
  };
  ASSERT_EQ(std::pair(low.x, high.x), range(&Point3::x));
  ASSERT_EQ(std::pair(low.y, high.y), range(&Point3::y));
  ASSERT_EQ(std::pair(low.z, high.z), range(&Point3::z));
}

TEST(ConvexPolyhedronTest, IsTheHullUnderOtherNumbers) {
  Random random(17);
  std::array<int, 4> dimensions{};
  for (int i = 0; i < 300; ++i) {
    const int n = static_cast<int>(random.between(1, i % 10 == 0 ? 300 : 20));
    const std::int64_t side = random.between(0, 3);
    std::vector<Point3> points;
    for (int k = 0; k < n; ++k) {
      const auto coordinate = [&] {
        return i % 2 ? static_cast<double>(random.between(-side, side)) : random.uniform(-1, 1);
      };
      points.push_back({coordinate(), coordinate(), coordinate()});
    }
    ASSERT_NO_FATAL_FAILURE(expect_hull(points)) << i;
    ++dimensions[static_cast<std::size_t>(ConvexPolyhedron(points).dimension())];
  }
  for (const int count : dimensions) EXPECT_GT(count, 10);
}

TEST(ConvexPolyhedronTest, PointsSegmentsAndPolygons) {
  const std::vector<Point3> point{{1, 2, 3}, {1, 2, 3}};
  ASSERT_NO_FATAL_FAILURE(expect_hull(point));
  const ConvexPolyhedron p(point);
  EXPECT_EQ(p.dimension(), 0);
  EXPECT_EQ(p.vertices().size(), 1u);
  EXPECT_EQ(p.source()[0], 0u);
  EXPECT_TRUE(p.neighbours(0).empty());
  EXPECT_EQ(p.facet_count(), 0u);

  const ConvexPolyhedron s(std::vector<Point3>{{2, 2, 2}, {0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(s.dimension(), 1);
  EXPECT_EQ(s.vertices().size(), 2u);
  EXPECT_EQ(s.neighbours(0).size(), 1u);
  EXPECT_EQ(s.neighbours(0)[0], 1u);
  EXPECT_EQ(s.neighbours(1)[0], 0u);
  EXPECT_EQ(s.facet_count(), 0u);

  const ConvexPolyhedron square(std::vector<Point3>{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}, {0.5, 0.5, 5}});
  EXPECT_EQ(square.dimension(), 2);
  EXPECT_EQ(square.facet_count(), 2u);
  for (std::uint32_t v = 0; v < 4; ++v) EXPECT_EQ(square.neighbours(v).size(), 2u);
}

// Neither the box's size nor its middle nor the order along the curve overflows or divides by zero.
TEST(ConvexPolyhedronTest, TheEndsOfTheRangeOfDoubles) {
  for (const double size : {least, 3 * least, 2.2250738585072014e-308, 1e-300, 1e300, largest}) {
    std::vector<Point3> cube;
    for (int i = 0; i < 8; ++i) cube.push_back({i & 1 ? size : -size, i & 2 ? size : -size, i & 4 ? size : -size});
    ASSERT_NO_FATAL_FAILURE(expect_hull(cube)) << size;
    EXPECT_EQ(ConvexPolyhedron(cube).facet_count(), 6u) << size;
    EXPECT_EQ(ConvexPolyhedron(cube).search_graph().middle, Point3()) << size;
  }
  ASSERT_NO_FATAL_FAILURE(
      expect_hull({{largest, 0, 0}, {-largest, least, 0}, {0, -largest, least}, {least, 0, largest}}));
  ASSERT_NO_FATAL_FAILURE(expect_hull({{largest, largest, largest}}));
  ASSERT_NO_FATAL_FAILURE(expect_hull({{-largest, 0, 0}, {largest, 0, 0}}));
}

TEST(ConvexPolyhedronTest, CopiesShareOneBlock) {
  const ConvexPolyhedron body(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const ConvexPolyhedron copy = body;
  EXPECT_EQ(copy.vertices().data(), body.vertices().data());
  EXPECT_EQ(&copy.search_graph(), &body.search_graph());
}

// The same points in the same order give the same numbers, which certificates rest on.
TEST(ConvexPolyhedronTest, IsReproducible) {
  Random random(5);
  std::vector<Point3> points;
  for (int i = 0; i < 500; ++i) points.push_back(tests::in_cube(random));
  const ConvexPolyhedron a(points), b(points);
  EXPECT_TRUE(std::ranges::equal(a.source(), b.source()));
  EXPECT_TRUE(std::ranges::equal(a.search_graph().neighbours, b.search_graph().neighbours));
}

TEST(ConvexPolyhedronTest, RefusesWhatIsNoSetOfPoints) {
  const auto code_of = [](const std::vector<Point3>& points) {
    try {
      const ConvexPolyhedron body(points);
    } catch (const Error& error) {
      return error.code();
    }
    ADD_FAILURE() << "no error";
    return ErrorCode{};
  };
  EXPECT_EQ(code_of({}), ErrorCode::bad_shape);
  for (const double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(code_of({{0, 0, 0}, {0, x, 0}}), ErrorCode::bad_value);
    EXPECT_EQ(code_of({{0, 0, -x}}), ErrorCode::bad_value);
  }
}

}  // namespace
}  // namespace sunder::solid
