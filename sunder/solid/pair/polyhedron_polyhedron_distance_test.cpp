#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>

#include <sunder/solid/object/bodies_test.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace sunder::solid {
namespace {

PolyhedronDistance distance(const ConvexPolyhedron& a, const ConvexPolyhedron& b) {
  return polyhedron_polyhedron_distance(a, Pose(), b, Pose());
}

// How many vertices of A and of B the closest features have.
std::array<int, 2> counts(const PolyhedronDistance& d) {
  if (!closest_of(d)) return {0, 0};
  return {closest_of(d)->features().count_a, closest_of(d)->features().count_b};
}

void expect_exact_distance(const PolyhedronDistance& d, double value) {
  EXPECT_EQ(compare_distance(d, value), Sign::zero);
  EXPECT_EQ(distance_of(d).low, value);
  EXPECT_EQ(distance_of(d).high, value);
  EXPECT_EQ(compare_distance(d, std::nextafter(value, HUGE_VAL)), Sign::negative);
  EXPECT_EQ(compare_distance(d, std::nextafter(value, 0.0)), Sign::positive);
}

TEST(PolyhedronPolyhedronDistanceTest, Features) {
  const PolyhedronDistance vertices = distance(two_cube, box({4, 5, 8}, {9, 9, 9}));
  EXPECT_EQ(counts(vertices), (std::array{1, 1}));
  expect_exact_distance(vertices, 7);  // (2, 3, 6)

  // An edge of the cube along z, and a vertex beside it.
  const PolyhedronDistance edge = distance(two_cube, body({{5, 6, 1}, {6, 6, 1}, {5, 7, 1}, {5, 6, 1.5}, {7, 7, 1.2}}));
  EXPECT_EQ(counts(edge)[0], 2);
  expect_exact_distance(edge, 5);
  const PolyhedronDistance back = distance(body({{5, 6, 1}, {6, 6, 1}, {5, 7, 1}, {6, 7, 1.5}}), two_cube);
  EXPECT_EQ(counts(back), (std::array{1, 2}));
  expect_exact_distance(back, 5);

  const PolyhedronDistance facet = distance(two_cube, body({{2.5, 1.125, 0.75}, {9, 0, 0}, {9, 9, 0}, {9, 0, 9}}));
  EXPECT_EQ(counts(facet), (std::array{3, 1}));
  expect_exact_distance(facet, 0.5);

  // Edges along z and along y.
  const PolyhedronDistance edges =
      distance(body({{0, 1, -9}, {0, 1, 9}, {-5, 0, 0}}), body({{3, -9, 0}, {3, 9, 0}, {9, 0, 1}}));
  EXPECT_EQ(counts(edges), (std::array{2, 2}));
  expect_exact_distance(edges, 3);
}

// Of all families: the nearest doubles of the exact points.
TEST(PolyhedronPolyhedronDistanceTest, NearestPointsAreRounded) {
  tests::SolidPairs pairs(tests::chosen_seed(87));
  int apart = 0;
  std::array<int, 4> of_features{};
  for (int round = 0; round < tests::scaled_count(1500, 300); ++round) {
    const tests::PairCase c = pairs.next();
    const PolyhedronDistance d = polyhedron_polyhedron_distance(c.a, c.pose_a, c.b, c.pose_b);
    if (d.meet()) continue;
    ++apart;
    ++of_features[static_cast<std::size_t>(counts(d)[0] + counts(d)[1] - 1)];
    const auto [of_a, of_b] = closest_points(*closest_of(d));
    const std::array<Point3, 2> points = closest_of(d)->nearest_points();
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(points[0][k], nearest(of_a.at)[k]) << tests::name_of(c.family);
      ASSERT_EQ(points[1][k], nearest(of_b.at)[k]) << tests::name_of(c.family);
      ASSERT_FALSE(points[0][k] == 0 && std::signbit(points[0][k]));
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(of_features[1], apart / 50);
  EXPECT_GT(of_features[2], apart / 50);
  EXPECT_GT(of_features[3], apart / 50);
}

TEST(PolyhedronPolyhedronDistanceTest, ParallelFeatures) {
  expect_exact_distance(distance(two_cube, box({5, 0.5, 0.5}, {6, 1.5, 1.5})), 3);  // facets
  expect_exact_distance(distance(two_cube, box({5, 1, 1}, {6, 7, 7})), 3);          // facets that overlap in part
  expect_exact_distance(distance(two_cube, box({5, 6, 1}, {6, 7, 7})), 5);          // edges
  expect_exact_distance(distance(two_cube, box({5, 2, 2}, {6, 7, 7})), 3);          // an edge above an edge
  expect_exact_distance(distance(body({{0, 0, 0}, {0, 0, 9}}), body({{3, 4, 2}, {3, 4, 5}})), 5);
  expect_exact_distance(distance(body({{0, 0, 0}, {0, 0, 9}}), body({{3, 0, 13}, {3, 0, 20}})), 5);
}

TEST(PolyhedronPolyhedronDistanceTest, AllDimensions) {
  const ConvexPolyhedron point = body({{3, 4, 0}}), segment = body({{3, 4, -1}, {3, 4, 1}}),
                         square = body({{3, 4, 1}, {3, 4, -1}, {4, 5, 1}, {4, 5, -1}}), origin = body({{0, 0, 0}});
  for (const ConvexPolyhedron& b : {point, segment, square}) {
    expect_exact_distance(distance(origin, b), 5);
    expect_exact_distance(distance(b, origin), 5);
  }
  expect_exact_distance(distance(body({{-2, -2, -3}, {9, -2, -3}, {-2, 9, -3}}), segment), 2);
}

TEST(PolyhedronPolyhedronDistanceTest, Meeting) {
  for (const PolyhedronDistance& d : {distance(two_cube, box({2, 2, 2}, {3, 3, 3})), distance(two_cube, two_cube)}) {
    EXPECT_TRUE(d.meet());
    EXPECT_FALSE(closest_of(d));
    EXPECT_EQ(distance_of(d).high, 0);
    EXPECT_EQ(compare_distance(d, 0), Sign::zero);
    EXPECT_EQ(compare_distance(d, 5e-324), Sign::negative);
  }
}

TEST(PolyhedronPolyhedronDistanceTest, OneBitApart) {
  const double next = std::nextafter(2.0, 3);
  expect_exact_distance(distance(two_cube, box({next, 0, 0}, {3, 1, 1})), next - 2);
  expect_exact_distance(distance(two_cube, box({next, 0.5, 0.5}, {3, 1, 1})), next - 2);
}

TEST(PolyhedronPolyhedronDistanceTest, FarBeyondTheRangeOfSquares) {
  expect_exact_distance(distance(body({{0, 0, 0}}), body({{3e-320, 0, 0}})), 3e-320);
  const PolyhedronDistance tiny = distance(body({{0, 0, 0}}), body({{5e-324, 5e-324, 5e-324}}));
  EXPECT_EQ(distance_of(tiny).low, 5e-324);
  EXPECT_EQ(distance_of(tiny).high, 1e-323);
  const PolyhedronDistance less = polyhedron_polyhedron_distance(
      body({{0, 0, 0}}), Pose(), body({{5e-324, 0, 0}}), Pose::from_matrix({0.25, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}));
  EXPECT_EQ(distance_of(less).low, 0);
  EXPECT_EQ(distance_of(less).high, 5e-324);
  EXPECT_EQ(compare_distance(less, 0), Sign::positive);
  const PolyhedronDistance beyond =
      distance(body({{-1.7e308, 0, 0}, {-1.7e308, 1, 0}}), body({{1.7e308, 1.7e308, 0}, {1.7e308, 1.7e308, 9}}));
  EXPECT_EQ(distance_of(beyond).low, std::numeric_limits<double>::max());
  EXPECT_EQ(distance_of(beyond).high, std::numeric_limits<double>::infinity());
  EXPECT_EQ(compare_distance(beyond, std::numeric_limits<double>::max()), Sign::positive);
}

// The exact descent alone, from a proposal that is none of the search's: bodies whose sizes no search can hold.
TEST(PolyhedronPolyhedronDistanceTest, FinishesWhereNoSearchCan) {
  const ConvexPolyhedron speck = box({0, 0, 0}, {0x1p-1000, 0x1p-1000, 0x1p-1000}),
                         slab = box({0x1p-999, -1, -1}, {1, 1, 1});
  const PolyhedronDistance d = distance(speck, slab);
  expect_exact_distance(d, 0x1p-1000);
}

// Two balls of n vertices: a constant times log2 n, as with the question whether they meet.
TEST(PolyhedronPolyhedronDistanceTest, ProbesGrowAsLogN) {
  for (const int n : {16, 128, 1024, 8192, 65536}) {
    std::vector<Point3> points;
    for (int k = 0; k < n; ++k) {  // a spiral on the sphere
      const double z = (2.0 * k + 1) / n - 1, r = std::sqrt(1 - z * z), turn = 2.399963229728653 * k;
      points.push_back({r * std::cos(turn), r * std::sin(turn), z});
    }
    const ConvexPolyhedron ball(points);
    for (const double far : {2.0001, 2.001, 2.5, 40.0}) {
      const PolyhedronDistance d = polyhedron_polyhedron_distance(
          ball, Pose(), ball, Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {far * 0.6, far * 0.48, far * 0.64}));
      ASSERT_FALSE(d.meet());
      EXPECT_NE(d.decided_by, DecidedBy::finishing);
      EXPECT_LE(static_cast<double>(d.cost.probes), 150 + 24 * std::log2(n)) << n << " " << far;
      EXPECT_NEAR(distance_of(d).low, far - 2, 8.0 / n);
    }
  }
}

}  // namespace
}  // namespace sunder::solid
