#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>

#include <sunder/planar/pair/polygon_polygon_depth.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sunder::planar {
namespace {

const ConvexPolygon four_square = ConvexPolygon::from_vertices({{0, 0}, {4, 0}, {4, 4}, {0, 4}});

PolygonDepth depth(const ConvexPolygon& a, const ConvexPolygon& b, const Pose& pose_a = {}, const Pose& pose_b = {}) {
  const PolygonDepthAnswer answer = polygon_polygon_depth(a, pose_a, b, pose_b);
  EXPECT_TRUE(answer.meet());
  return std::get<PolygonDepth>(answer.evidence);
}

void expect_depth(const PolygonDepth& d, double value) {
  EXPECT_EQ(compare_depth(d, value), Sign::zero);
  EXPECT_EQ(d.depth.low, value);
  EXPECT_EQ(d.depth.high, value);
  EXPECT_EQ(compare_depth(d, std::nextafter(value, HUGE_VAL)), Sign::negative);
}

TEST(PolygonPolygonDepthTest, Features) {
  // A corner of a triangle in the square's right edge.
  const PolygonDepth corner = depth(four_square, ConvexPolygon::from_vertices({{9, 1}, {9, 4}, {3.5, 2}}));
  expect_depth(corner, 0.5);
  EXPECT_TRUE(corner.edge_of_a);
  EXPECT_FALSE(corner.edge_of_b);
  EXPECT_EQ(corner.a, 1u);
  EXPECT_EQ(corner.b, 2u);
  EXPECT_EQ(corner.direction[0].sign(), Sign::positive);
  EXPECT_EQ(corner.direction[1].sign(), Sign::zero);

  // The same with the names exchanged, and as mirror images: the edge is named by the polygon's own order.
  const PolygonDepth swapped = depth(ConvexPolygon::from_vertices({{9, 1}, {9, 4}, {3.5, 2}}), four_square);
  expect_depth(swapped, 0.5);
  EXPECT_TRUE(swapped.edge_of_b);
  EXPECT_EQ(swapped.a, 2u);
  EXPECT_EQ(swapped.b, 1u);
  EXPECT_EQ(swapped.direction[0].sign(), Sign::negative);
  const Pose mirror = Pose::from_matrix({-1, 0, 0, 1}, {0, 0});
  const PolygonDepth mirrored =
      depth(four_square, ConvexPolygon::from_vertices({{9, 1}, {9, 4}, {3.5, 2}}), mirror, mirror);
  expect_depth(mirrored, 0.5);
  EXPECT_EQ(mirrored.a, 1u);
  EXPECT_EQ(mirrored.b, 2u);
  EXPECT_EQ(mirrored.direction[0].sign(), Sign::negative);

  // One within the other; and a depth that no double is.
  expect_depth(depth(four_square, ConvexPolygon::from_vertices({{1, 2}, {2, 2}, {2, 3}})), 2);
  const PolygonDepth root = depth(ConvexPolygon::from_vertices({{0, 0}, {3, 0}, {0, 3}}),
                                  ConvexPolygon::from_vertices({{1, 1}, {9, 1}, {9, 9}, {1, 9}}));
  EXPECT_EQ(root.squared, ExactFraction{Dyadic(0.5)});
  EXPECT_EQ(root.depth.high, std::nextafter(root.depth.low, 1));
}

TEST(PolygonPolygonDepthTest, FlatOnesAndContacts) {
  const auto point = [](double x, double y) { return ConvexPolygon::from_vertices({{x, y}}); };
  const auto segment = [](Point2 p, Point2 q) { return ConvexPolygon::from_vertices({p, q}); };
  expect_depth(depth(four_square, point(1, 2)), 1);
  expect_depth(depth(point(1, 2), four_square), 1);
  expect_depth(depth(four_square, segment({3, 2}, {9, 2})), 1);
  expect_depth(depth(segment({-1, 0}, {3, 0}), segment({0, -4}, {0, 5})), 1);  // a cross
  // On one line, A - B has no interior.
  expect_depth(depth(segment({0, 0}, {3, 0}), segment({1, 0}, {9, 0})), 0);
  expect_depth(depth(segment({0, 0}, {3, 0}), point(1, 0)), 0);
  expect_depth(depth(point(1, 0), point(1, 0)), 0);
  // They touch.
  expect_depth(depth(four_square, ConvexPolygon::from_vertices({{4, 4}, {9, 4}, {9, 9}})), 0);
  expect_depth(depth(four_square, ConvexPolygon::from_vertices({{4, 1}, {9, 1}, {4, 3}})), 0);
  // They are apart.
  const PolygonDepthAnswer apart = polygon_polygon_depth(four_square, Pose(), point(std::nextafter(4.0, 5), 2), Pose());
  EXPECT_FALSE(apart.meet());
  EXPECT_TRUE(std::holds_alternative<Separation>(apart.evidence));
}

TEST(PolygonPolygonDepthTest, FarBeyondTheRangeOfSquares) {
  const auto square = [](double low, double high) {
    return ConvexPolygon::from_vertices({{low, low}, {high, low}, {high, high}, {low, high}});
  };
  expect_depth(depth(square(0, 0x1p-1070), square(0x1p-1072, 0x1p-1070)), 0x3p-1072);
  expect_depth(depth(square(0, 0x1p1020), square(0x1p1018, 0x1p1020)), 0x3p1018);
  // Beyond all doubles: the enclosure is true still.
  const PolygonDepth beyond = depth(square(-0x1.8p1023, 0x1.8p1023), square(-0x1.8p1023, 0x1.8p1023));
  EXPECT_EQ(beyond.depth.low, std::numeric_limits<double>::max());
  EXPECT_EQ(beyond.depth.high, std::numeric_limits<double>::infinity());
}

// Probes: two searches by bisection for each pair of an edge and a polygon.
TEST(PolygonPolygonDepthTest, ProbesGrowAsNLogN) {
  for (std::uint32_t n = 8; n <= 1u << 14; n *= 8) {
    const ConvexPolygon a = tests::regular_polygon(n), b = tests::regular_polygon(n + 3, 2, 0.1);
    const PolygonDepthAnswer answer = polygon_polygon_depth(a, Pose(), b, Pose::from_matrix({1, 0, 0, 1}, {1.25, 0.5}));
    ASSERT_TRUE(answer.meet());
    const double m = n + 3, pair = 12 * std::log2(m) + 20;
    EXPECT_LE(static_cast<double>(answer.cost.probes), n * (std::log2(m) + 1) + m * (std::log2(n) + 1) + pair) << n;
    // Intervals tell most edges from the nearest one.
    EXPECT_LE(answer.cost.exact, 3 * std::log2(m) + 20) << n;
  }
}

}  // namespace
}  // namespace sunder::planar
