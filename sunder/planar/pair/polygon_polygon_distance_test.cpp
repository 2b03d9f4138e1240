#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>

#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace sunder::planar {
namespace {

using tests::PlanarFamily;

const ConvexPolygon two_square = ConvexPolygon::from_vertices({{0, 0}, {2, 0}, {2, 2}, {0, 2}});

PolygonDistance distance(const ConvexPolygon& a, const ConvexPolygon& b) {
  return polygon_polygon_distance(a, Pose(), b, Pose());
}

TEST(PolygonPolygonDistanceTest, Features) {
  const PolygonDistance corner = distance(two_square, ConvexPolygon::from_vertices({{5, 6}, {9, 6}, {9, 9}}));
  ASSERT_TRUE(closest_of(corner));
  EXPECT_FALSE(closest_of(corner)->edge_of_a || closest_of(corner)->edge_of_b);
  EXPECT_EQ(closest_of(corner)->a, 2u);
  EXPECT_EQ(closest_of(corner)->b, 0u);
  EXPECT_EQ(compare_distance(corner, 5), Sign::zero);
  EXPECT_EQ(compare_distance(corner, std::nextafter(5.0, 6)), Sign::negative);
  EXPECT_EQ(compare_distance(corner, std::nextafter(5.0, 4)), Sign::positive);

  const PolygonDistance edge = distance(two_square, ConvexPolygon::from_vertices({{3, 1}, {9, 0}, {9, 9}}));
  ASSERT_TRUE(closest_of(edge));
  EXPECT_TRUE(closest_of(edge)->edge_of_a);
  EXPECT_EQ(closest_of(edge)->a, 1u);
  EXPECT_EQ(closest_of(edge)->b, 0u);
  EXPECT_EQ(compare_distance(edge, 1), Sign::zero);
  EXPECT_EQ(distance_of(edge).low, 1);
  EXPECT_EQ(distance_of(edge).high, 1);

  const PolygonDistance points =
      distance(ConvexPolygon::from_vertices({{0, 0}}), ConvexPolygon::from_vertices({{3, 4}}));
  EXPECT_EQ(compare_distance(points, 5), Sign::zero);
}

TEST(PolygonPolygonDistanceTest, Meeting) {
  const PolygonDistance touching = distance(two_square, ConvexPolygon::from_vertices({{2, 1}, {3, 0}, {3, 3}}));
  EXPECT_TRUE(touching.meet());
  EXPECT_FALSE(closest_of(touching));
  EXPECT_EQ(distance_of(touching).high, 0);
  EXPECT_EQ(compare_distance(touching, 0), Sign::zero);
  EXPECT_EQ(compare_distance(touching, 5e-324), Sign::negative);
}

TEST(PolygonPolygonDistanceTest, FarBeyondTheRangeOfSquares) {
  const auto point = [](double x, double y) { return ConvexPolygon::from_vertices({{x, y}}); };
  const PolygonDistance tiny = distance(point(0, 0), point(3e-320, 4e-320)),
                        huge = distance(point(0, 0), point(3e300, 4e300));
  EXPECT_NEAR(distance_of(tiny).low / 5e-320, 1, 1e-3);
  EXPECT_GE(distance_of(tiny).high, distance_of(tiny).low);
  EXPECT_NEAR(distance_of(huge).low / 5e300, 1, 1e-12);
  EXPECT_LE(distance_of(huge).high / distance_of(huge).low, 1 + 1e-15);
  // Beyond all doubles: the enclosure is true still.
  const PolygonDistance beyond = distance(point(-1.7e308, 0), point(1.7e308, 1.7e308));
  EXPECT_EQ(distance_of(beyond).low, std::numeric_limits<double>::max());
  EXPECT_EQ(distance_of(beyond).high, std::numeric_limits<double>::infinity());
  EXPECT_EQ(compare_distance(beyond, std::numeric_limits<double>::max()), Sign::positive);
}

TEST(PolygonPolygonDistanceTest, AgreesWithTheScan) {
  const int count = tests::scaled_count(4000);
  tests::PlanarPairs pairs(tests::chosen_seed(31));
  int apart = 0, edges_a = 0, edges_b = 0, vertices = 0, doubles = 0;
  for (int i = 0; i < count; ++i) {
    const tests::PlanarCase c = pairs.next(i % 4 == 0 ? PlanarFamily::grid : static_cast<PlanarFamily>(i % 9));
    if (c.a.size() + c.b.size() > 60) continue;
    const PolygonDistance d = polygon_polygon_distance(c.a, c.pose_a, c.b, c.pose_b);
    const PolygonDistance scan = polygon_polygon_distance_by_scan(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(d.meet(), scan.meet()) << i;
    ASSERT_EQ(d.meet(), !closest_of(d)) << i;
    ASSERT_EQ(d.meet(), !closest_of(scan)) << i;
    if (d.meet()) continue;
    ++apart;
    (closest_of(d)->edge_of_a ? edges_a : closest_of(d)->edge_of_b ? edges_b : vertices) += 1;
    const ExactFraction& squared = closest_of(d)->squared;
    ASSERT_EQ(squared, closest_of(scan)->squared)
        << i << " " << name_of(c.family) << " " << distance_of(d).low << " " << distance_of(scan).low;
    // The enclosure: low^2 <= numerator / denominator <= high^2, and no double is between.
    const Dyadic low(distance_of(d).low), high(distance_of(d).high);
    ASSERT_GE(squared, ExactFraction{low * low}) << i;
    ASSERT_LE(squared, ExactFraction{high * high}) << i;
    const bool is_double = squared == ExactFraction{low * low};
    doubles += is_double ? 1 : 0;
    ASSERT_EQ(distance_of(d).high, is_double ? distance_of(d).low : std::nextafter(distance_of(d).low, HUGE_VAL)) << i;
    ASSERT_NE(compare_distance(d, distance_of(d).low), Sign::negative) << i;
    ASSERT_NE(compare_distance(d, distance_of(d).high), Sign::positive) << i;
  }
  if (count < 2000) return;
  EXPECT_GT(apart, count / 4);
  EXPECT_GT(edges_a, apart / 10);
  EXPECT_GT(edges_b, apart / 10);
  EXPECT_GT(vertices, apart / 10);
  EXPECT_GT(doubles, apart / 50);
  EXPECT_LT(doubles, apart / 2);
}

// Two regular polygons of n vertices: a constant times log2 n.
TEST(PolygonPolygonDistanceTest, ProbesGrowAsLogN) {
  for (std::uint32_t n = 8; n <= 1u << 20; n *= 8) {
    const ConvexPolygon a = tests::regular_polygon(n), b = tests::regular_polygon(n + 3, 2, 0.1);
    for (const double angle : {0.1, 1.0, 2.5, 4.0, 5.7}) {
      for (const double far : {3.001, 4.0, 50.0}) {
        const Pose there = Pose::from_matrix({1, 0, 0, 1}, {far * std::cos(angle), far * std::sin(angle)});
        const PolygonDistance d = polygon_polygon_distance(a, Pose(), b, there);
        ASSERT_FALSE(d.meet());
        const double roughly = far - 3;
        EXPECT_NEAR(distance_of(d).low, roughly, 5.0 / n / n * 10 + 1e-9) << n;
        EXPECT_LE(static_cast<double>(d.cost.probes), 12 * std::log2(n) + 20) << n << " " << angle << " " << far;
      }
    }
  }
}

}  // namespace
}  // namespace sunder::planar
