#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>

#include <sunder/planar/pair/polygon_polygon_boundary.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace sunder::planar {
namespace {

using tests::PlanarFamily;

Relation relation(const ConvexPolygon& a, const ConvexPolygon& b) {
  return polygon_polygon_boundary(a, Pose(), b, Pose()).relation;
}

TEST(PolygonPolygonBoundaryTest, Examples) {
  const auto square = [](double x, double y, double size) {
    return ConvexPolygon::from_vertices({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}});
  };
  EXPECT_EQ(relation(square(0, 0, 4), square(1, 1, 2)), Relation::b_inside_a);
  EXPECT_EQ(relation(square(1, 1, 2), square(0, 0, 4)), Relation::a_inside_b);
  EXPECT_EQ(relation(square(0, 0, 4), square(0, 1, 2)), Relation::meeting);  // from within
  EXPECT_EQ(relation(square(0, 0, 4), square(4, 4, 2)), Relation::meeting);
  EXPECT_EQ(relation(square(0, 0, 4), square(5, 4, 2)), Relation::none);
  EXPECT_EQ(relation(square(0, 0, 4), square(0, 0, 4)), Relation::meeting);
  EXPECT_EQ(relation(square(0, 0, 4), ConvexPolygon::from_vertices({{1, 1}})), Relation::b_inside_a);
  EXPECT_EQ(relation(square(0, 0, 4), ConvexPolygon::from_vertices({{1, 4}})), Relation::meeting);
  EXPECT_EQ(relation(ConvexPolygon::from_vertices({{1, 1}}), ConvexPolygon::from_vertices({{1, 1}})),
            Relation::meeting);
}

// The example of Theorem 5: the roots of z^n = 1, and those of z^n = r^n with r between 1 and 1 / cos(2 pi / n): any
// one vertex of the outer polygon that is moved inwards by little makes the boundaries meet.
TEST(PolygonPolygonBoundaryTest, EachVertexMayBeTheOneThatMatters) {
  for (const std::uint32_t n : {5u, 16u, 101u}) {
    const double angle = 2 * std::numbers::pi / n, r = 0.5 + 0.5 / std::cos(angle);
    std::vector<Point2> inner, outer;
    for (std::uint32_t k = 0; k < n; ++k) {
      inner.push_back({std::cos(k * angle), std::sin(k * angle)});
      outer.push_back({r * std::cos(k * angle), r * std::sin(k * angle)});
    }
    const ConvexPolygon p = ConvexPolygon::from_vertices(inner);
    EXPECT_EQ(relation(p, ConvexPolygon::from_vertices(outer)), Relation::a_inside_b) << n;
    for (std::uint32_t k = 0; k < n; ++k) {
      std::vector<Point2> moved = outer;
      const double s = 0.5 + 0.5 * std::cos(angle);  // below 1; on the chord of its neighbours, but for rounding
      moved[k] = {s * std::cos(k * angle), s * std::sin(k * angle)};
      EXPECT_EQ(relation(p, ConvexPolygon::hull_of(moved)), Relation::meeting) << n << " " << k;
    }
  }
}

TEST(PolygonPolygonBoundaryTest, AgreesWithTheScan) {
  const int count = tests::scaled_count(6000);
  tests::PlanarPairs pairs(tests::chosen_seed(37));
  std::map<Relation, int> seen;
  for (int i = 0; i < count; ++i) {
    const tests::PlanarCase c = pairs.next(i % 3 == 0 ? PlanarFamily::contained : static_cast<PlanarFamily>(i % 9));
    const RelationAnswer answer = polygon_polygon_boundary(c.a, c.pose_a, c.b, c.pose_b);
    const RelationAnswer scan = polygon_polygon_boundary_by_scan(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(answer.relation, scan.relation) << i << " " << name_of(c.family);
    ++seen[scan.relation];
  }
  if (count < 2000) return;
  for (const Relation b : {Relation::none, Relation::meeting, Relation::a_inside_b, Relation::b_inside_a}) {
    EXPECT_GT(seen[b], count / 50) << name_of(b);
  }
}

// Linear, and no less: the probes where one is inside the other.
TEST(PolygonPolygonBoundaryTest, ProbesGrowAsN) {
  for (std::uint32_t n = 16; n <= 1u << 16; n *= 16) {
    const ConvexPolygon a = tests::regular_polygon(n), b = tests::regular_polygon(n, 2);
    for (const auto& answer :
         {polygon_polygon_boundary(a, Pose(), b, Pose()), polygon_polygon_boundary(b, Pose(), a, Pose())}) {
      EXPECT_LE(answer.cost.probes, 8 * std::uint64_t{n} + 100);
      EXPECT_GE(answer.cost.probes, n);
    }
  }
}

}  // namespace
}  // namespace sunder::planar
