// The loop of the search on a support that is a list of points, so that each way in which it ends is seen; what it
// finds of bodies is tested with the questions that it is for.
#include <sunder/solid/search/gjk.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sunder::solid {
namespace {

// The difference is the hull of these points. The first `top` of them alone are looked at, until refine().
struct PointSupport {
  PointSupport(const std::vector<Point3>& of, const std::size_t& top) : points(of), seen(std::min(top, of.size())) {}

  double scale = 1;
  std::vector<Point3> points;
  std::size_t seen;

  static double along(const Point3& d, const Point3& p) { return d.x * p.x + d.y * p.y + d.z * p.z; }
  static Point3 first_direction() { return {1, 0, 0}; }
  DifferenceVertex furthest(const Point3& d, const DifferenceSimplex&, Cost& cost) const {
    DifferenceVertex w{points[0], 0, 0};
    for (std::uint32_t k = 1; k < seen; ++k) {
      ++cost.probes;
      if (along(d, points[k]) > along(d, w.at)) w = {points[k], k, k};
    }
    return w;
  }
  static bool are_same(const DifferenceVertex& v, const DifferenceVertex& w) { return v.a == w.a; }
  static double noise(const Point3&, const DifferenceVertex&) { return 0; }
  static double noise2(const DifferenceVertex&) { return 0; }
  bool is_coarse() const { return seen < points.size(); }
  void refine() { seen = points.size(); }
};
using PointSearch = Gjk<double, PointSupport>;

const std::vector<Point3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

std::vector<Point3> moved(std::vector<Point3> points, const Point3& by) {
  for (Point3& p : points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return points;
}

PointSearch search_of(const std::vector<Point3>& points, std::size_t top = 100) { return {points, top}; }

TEST(Gjk, EndsAtTheNearestPoint) {
  PointSearch search = search_of(moved(octahedron, {2, 2, 2}));
  Cost cost;
  search.begin({});
  EXPECT_EQ(search.run({}, cost), GjkEnd::no_gain);
  EXPECT_EQ(search.simplex.count, 3);  // the facet (1, 2, 2), (2, 1, 2), (2, 2, 1)
  EXPECT_NEAR(search.distance2, 25.0 / 3, 1e-12);
  const auto mean = mean_nearest(search.simplex);
  ASSERT_TRUE(mean.has_value());
  ASSERT_EQ(mean->count, 3U);
  for (const auto& part : *mean) EXPECT_NEAR(part.weight / mean->total, 1.0 / 3, 1e-12);
}

TEST(Gjk, EndsInsideWhereTheOriginIs) {
  PointSearch search = search_of(moved(octahedron, {0.1, 0.15, 0.05}));
  Cost cost;
  search.begin({1, 2, 3});
  EXPECT_EQ(search.run({}, cost), GjkEnd::inside);
  EXPECT_EQ(search.simplex.count, 4);
  // A vertex at the origin: its face is no further from there than nothing.
  PointSearch vertex = search_of(moved(octahedron, {1, 0, 0}));
  vertex.begin({-1, 0, 0});
  EXPECT_EQ(vertex.run({}, cost), GjkEnd::inside);
}

TEST(Gjk, StopsWhereItsCallerSaysSo) {
  PointSearch search = search_of(moved(octahedron, {-2, -2, -2}));
  Cost cost;
  search.begin({});
  const auto parts = [&](const DifferenceVertex& w) { return search.gap_at(w) > 0; };
  EXPECT_EQ(search.run({}, cost, parts), GjkEnd::stopped);
  EXPECT_EQ(cost.iterations, 1U);
  EXPECT_EQ(search.simplex.count, 0);
  int steps = 0, nearer = 0;
  const auto second = [&](bool is_nearer) {
    nearer += is_nearer ? 1 : 0;
    return ++steps == 2;
  };
  EXPECT_EQ(search.run({}, cost, GjkNever(), second), GjkEnd::stopped);
  EXPECT_EQ(steps, 2);
  EXPECT_EQ(nearer, 2);
  EXPECT_EQ(cost.iterations, 3U);
}

TEST(Gjk, EndsAfterSoManySteps) {
  PointSearch search = search_of(moved(octahedron, {2, 2, 2}));
  Cost cost;
  search.begin({1, 0, 0});
  EXPECT_EQ(search.run({.steps = 2}, cost), GjkEnd::too_long);
  EXPECT_EQ(cost.iterations, 2U);
}

// Its points are as far from the origin as a list says, whatever is asked.
struct ScriptedSupport : PointSupport {
  ScriptedSupport(const std::vector<Point3>& of, const std::vector<double>& distances)
      : PointSupport(of, of.size()), script(distances) {}

  std::vector<double> script;
  std::uint32_t asked = 0;

  DifferenceVertex furthest(const Point3&, const DifferenceSimplex&, Cost&) {
    const double x = script.at(asked);
    return {{x, 0, 0}, asked, asked++};
  }
  static double noise(const Point3&, const DifferenceVertex&) { return -1e300; }
};

TEST(Gjk, EndsWhereItComesNoNearer) {
  const std::vector<double> script{5, 6, 7, 4, 6, 4, 4, 3, 8, 8, 8, 8, 8};
  const std::size_t ends[] = {2, 3, 7, 12};  // after so many steps that come no nearer: 6; 6, 7; 6, 4, 4; the 8
  for (int in_vain = 1; in_vain <= 4; ++in_vain) {
    Gjk<double, ScriptedSupport> search(octahedron, script);
    Cost cost;
    search.begin({});
    double nearest = 100;
    const auto looks = [&](bool is_nearer) {
      const double x = script[search.support.asked - 1];
      EXPECT_EQ(is_nearer, x < nearest);
      nearest = std::min(nearest, x);
      search.simplex.count = 0;  // each point alone
      return false;
    };
    EXPECT_EQ(search.run({.in_vain = in_vain}, cost, GjkNever(), looks), GjkEnd::circling);
    EXPECT_EQ(search.support.asked, ends[in_vain - 1]) << in_vain;
  }
}

TEST(Gjk, LooksCloselyBeforeItEnds) {
  // Of the first four points only it would end elsewhere.
  const std::vector<Point3> points = moved(octahedron, {2, 2, 2});
  for (const std::size_t top : {1U, 2U, 4U, 100U}) {
    PointSearch search = search_of(points, top);
    Cost cost;
    search.begin({});
    bool is_whole = true;
    const auto looks = [&](const DifferenceVertex&) {
      is_whole = is_whole && !search.support.is_coarse();
      return false;
    };
    EXPECT_EQ(search.run({}, cost, looks), GjkEnd::no_gain) << top;
    EXPECT_TRUE(is_whole) << top;
    EXPECT_NEAR(search.distance2, 25.0 / 3, 1e-12) << top;
  }
  // What parts the first points is looked at again among all, before the simplex has any.
  PointSearch search = search_of(moved(octahedron, {-2, -2, -2}), 2);
  Cost cost;
  search.begin({});
  const auto first = [](const DifferenceVertex&) { return true; };
  EXPECT_EQ(search.run({}, cost, first), GjkEnd::stopped);
  EXPECT_EQ(search.simplex.count, 0);
  EXPECT_EQ(cost.iterations, 2U);
  // What does not is a step.
  PointSearch other = search_of(moved(octahedron, {2, 0, 0}), 2);
  other.begin({});
  EXPECT_EQ(other.run({}, cost, first), GjkEnd::stopped);
  EXPECT_EQ(other.simplex.count, 1);
}

struct NoisySupport : PointSupport {
  using PointSupport::PointSupport;
  static double noise(const Point3&, const DifferenceVertex&) { return 0.5; }
};

TEST(Gjk, GainsByMoreThanNoiseAndByNewVertices) {
  Gjk<double, NoisySupport> search(octahedron, octahedron.size());
  search.begin({});
  EXPECT_TRUE(search.gains_by({{-9, 0, 0}, 0, 0}));  // than by none
  search.simplex.vertex[0] = {{1, 0, 0}, 0, 0};
  search.simplex.count = 1;
  EXPECT_FALSE(search.gains_by({{1.4, 0, 0}, 1, 1}));
  EXPECT_TRUE(search.gains_by({{1.6, 0, 0}, 1, 1}));
  EXPECT_FALSE(search.gains_by({{1.6, 0, 0}, 0, 0}));
  search.begin({0, 1, 0});
  EXPECT_EQ(search.simplex.count, 0);
  EXPECT_EQ(search.direction, (Point3{0, 1, 0}));
}

TEST(Gjk, FreeSlotsAreNotOfTheSimplex) {
  DifferenceSimplex simplex;
  EXPECT_EQ(free_slot(simplex), 0U);
  for (const std::uint32_t used : {1U, 0U, 3U}) simplex.vertex[static_cast<std::size_t>(simplex.count++)].a = used;
  EXPECT_EQ(free_slot(simplex), 2U);
  simplex.vertex[static_cast<std::size_t>(simplex.count++)].a = 2;
  EXPECT_EQ(free_slot(simplex), 4U);
}

TEST(Gjk, NothingMakesNoMean) {
  DifferenceSimplex simplex;
  EXPECT_FALSE(mean_nearest(simplex).has_value());
  simplex.count = 1;
  EXPECT_TRUE(mean_nearest(simplex).has_value());
  // A vertex of negative weight is none of the mean.
  simplex.vertex[0] = {{1, 0, 0}, 0, 0};
  simplex.vertex[1] = {{2, 0, 0}, 1, 1};
  simplex.count = 2;
  const auto mean = mean_nearest(simplex);
  ASSERT_TRUE(mean.has_value());
  ASSERT_EQ(mean->count, 1U);
  EXPECT_EQ(mean->parts[0].a, 0U);
  EXPECT_EQ(mean->total, mean->parts[0].weight);
}

}  // namespace
}  // namespace sunder::solid
