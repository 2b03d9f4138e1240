#include <sunder/solid/object/bodies_test.h>
#include <sunder/solid/pair/polyhedron_polyhedron_depth.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace sunder::solid {
namespace {

using tests::shift;

ConvexPolyhedron ball(int n) {  // a spiral on the sphere
  std::vector<Point3> points;
  for (int k = 0; k < n; ++k) {
    const double z = (2.0 * k + 1) / n - 1, r = std::sqrt(1 - z * z), turn = 2.399963229728653 * k;
    points.push_back({r * std::cos(turn), r * std::sin(turn), z});
  }
  return ConvexPolyhedron(points);
}

PolyhedraOverlap depth(const ConvexPolyhedron& a, const ConvexPolyhedron& b) {
  return std::get<PolyhedraOverlap>(polyhedron_polyhedron_depth(a, Pose(), b, Pose()).evidence);
}

void expect_exact_depth(const PolyhedraOverlap& d, double value) {
  ASSERT_TRUE(d.exact);
  EXPECT_EQ(compare_depth(d, value), Sign::zero);
  EXPECT_EQ(d.depth.low, value);
  EXPECT_EQ(d.depth.high, value);
  EXPECT_EQ(compare_depth(d, std::nextafter(value, HUGE_VAL)), Sign::negative);
  EXPECT_EQ(std::holds_alternative<DepthSurface>(d.proof_of_low), value > 0);
}

TEST(PolyhedronPolyhedronDepthTest, Features) {
  // A corner of a turned body in the cube's face.
  const PolyhedraOverlap facet = depth(two_cube, body({{1.5, 1, 1}, {9, 0, 0}, {9, 9, 0}, {9, 0, 9}}));
  expect_exact_depth(facet, 0.5);
  EXPECT_EQ(facet.exact->features.of_a.size(), 3u);
  EXPECT_EQ(facet.exact->features.of_b.size(), 1u);
  const Vector3<Dyadic> d = facet.direction.exact();
  EXPECT_EQ(d.x.sign(), Sign::positive);
  EXPECT_EQ(d.y.sign(), Sign::zero);
  EXPECT_EQ(d.z.sign(), Sign::zero);

  // Edges along y and along z, back to back.
  const PolyhedraOverlap edges = depth(body({{1, -9, 0}, {1, 9, 0}, {-5, 0, 9}, {-5, 0, -9}}),
                                       body({{0, 0, -9}, {0, 0, 9}, {9, 9, 0}, {9, -9, 0}}));
  expect_exact_depth(edges, 1);
  EXPECT_EQ(edges.exact->features.of_a.size(), 2u);
  EXPECT_EQ(edges.exact->features.of_b.size(), 2u);

  // Along (1, 1, 1): no double.
  const PolyhedraOverlap corner =
      depth(body({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}), box({0.5, 0.5, 0.5}, {9, 9, 9}));
  ASSERT_TRUE(corner.exact);
  EXPECT_EQ(corner.exact->squared.text(), "3/4");
  EXPECT_EQ(corner.depth.high, std::nextafter(corner.depth.low, 1));
}

TEST(PolyhedronPolyhedronDepthTest, NestedTouchingAndApart) {
  expect_exact_depth(depth(two_cube, two_cube), 2);
  expect_exact_depth(depth(two_cube, box({0.5, 0.75, 0.75}, {0.75, 1, 1})), 0.75);
  expect_exact_depth(depth(two_cube, box({2, 0, 0}, {3, 1, 1})), 0);
  expect_exact_depth(depth(two_cube, box({2, 2, 2}, {3, 3, 3})), 0);
  const double inside = std::nextafter(2.0, 0.0);
  expect_exact_depth(depth(two_cube, box({inside, 0, 0}, {3, 1, 1})), 2 - inside);
  EXPECT_FALSE(polyhedron_polyhedron_depth(two_cube, Pose(), box({2.5, 0, 0}, {3, 1, 1}), Pose()).meet());
}

TEST(PolyhedronPolyhedronDepthTest, AllDimensions) {
  const ConvexPolyhedron point = body({{1, 1, 0.5}}), segment = body({{1, 1, -3}, {1, 1, 1.5}}),
                         square = body({{0, 0, 1.5}, {3, 0, 1.5}, {0, 3, 1.5}, {3, 3, 1.5}});
  expect_exact_depth(depth(two_cube, point), 0.5);
  expect_exact_depth(depth(two_cube, segment), 1);
  expect_exact_depth(depth(segment, two_cube), 1);
  expect_exact_depth(depth(two_cube, square), 0.5);
  // The difference is solid, a parallelogram, a segment, a point.
  expect_exact_depth(depth(square, body({{1, 1, 0}, {1, 1, 2}})), 0.5);
  expect_exact_depth(depth(square, square), 0);
  expect_exact_depth(depth(segment, body({{0, 0, 0.5}, {2, 2, 0.5}})), 0);
  expect_exact_depth(depth(segment, segment), 0);
  expect_exact_depth(depth(point, point), 0);
}

TEST(PolyhedronPolyhedronDepthTest, AtTheEndsOfTheRange) {
  for (const double s : {0x1p1000, 0x1p-1000}) {
    expect_exact_depth(depth(box({0, 0, 0}, {2 * s, 2 * s, 2 * s}), box({1.5 * s, s / 2, 0}, {9 * s, s, s})), 0.5 * s);
  }
  expect_exact_depth(depth(box({0, 0, 0}, {5e-324, 1, 1}), box({0, 0, 0}, {1, 1, 1})), 5e-324);
  const double most = std::numeric_limits<double>::max();
  const ConvexPolyhedron huge = box({-most, -most, -most}, {most, most, most});
  const PolyhedraOverlap beyond = depth(huge, huge);
  EXPECT_EQ(beyond.depth.low, most);
  EXPECT_EQ(beyond.depth.high, std::numeric_limits<double>::infinity());
  EXPECT_EQ(compare_depth(beyond, most), Sign::positive);
}

// Two round bodies of one centre: nearly all facets are as far. It ends, and says how much it knows.
TEST(PolyhedronPolyhedronDepthTest, LargeBodiesOfOneCentreAreEnclosed) {
  const ConvexPolyhedron a = ball(1500), b = ball(1400);
  const PolyhedraOverlap d = depth(a, b);
  EXPECT_FALSE(d.exact);
  EXPECT_LT(d.depth.low, d.depth.high);
  EXPECT_GT(d.depth.low, 1.98);
  EXPECT_LT(d.depth.high, 2);
  EXPECT_LT(d.depth.high - d.depth.low, 0.01);
  EXPECT_EQ(compare_depth(d, 1.9), Sign::positive);
  EXPECT_EQ(compare_depth(d, 2), Sign::negative);
  EXPECT_FALSE(compare_depth(d, (d.depth.low + d.depth.high) / 2).has_value());
  ASSERT_TRUE(std::holds_alternative<DepthSurface>(d.proof_of_low));
}

// Beside each other a few steps do, however many vertices there are.
TEST(PolyhedronPolyhedronDepthTest, StepsStayFew) {
  for (const int n : {100, 1000, 10000}) {
    const ConvexPolyhedron a = ball(n);
    const PolyhedronDepth d = polyhedron_polyhedron_depth(a, Pose(), a, shift(1.1, 0.7, 0.4));
    const PolyhedraOverlap* overlap = overlap_of(d);
    ASSERT_TRUE(overlap != nullptr && overlap->exact);
    EXPECT_LT(d.cost.iterations, 80u) << n;
    EXPECT_NEAR(overlap->depth.low, 2 - std::sqrt(1.1 * 1.1 + 0.7 * 0.7 + 0.4 * 0.4), 8.0 / n);
  }
}

}  // namespace
}  // namespace sunder::solid
