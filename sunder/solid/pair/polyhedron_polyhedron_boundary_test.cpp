#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>

#include <sunder/solid/pair/polyhedron_polyhedron_boundary.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

using tests::Family, tests::shift;

ConvexPolyhedron cube_between(double low, double high) { return ConvexPolyhedron(tests::cube_corners(low, high)); }
ConvexPolyhedron hull(const std::vector<Point3>& points) { return ConvexPolyhedron(points); }

Relation relation(const ConvexPolyhedron& a, const ConvexPolyhedron& b, const Pose& pose_b = Pose()) {
  return polyhedron_polyhedron_boundary(a, Pose(), b, pose_b).relation;
}

TEST(PolyhedronPolyhedronBoundaryTest, Examples) {
  EXPECT_EQ(relation(cube_between(0, 4), cube_between(1, 3)), Relation::b_inside_a);
  EXPECT_EQ(relation(cube_between(1, 3), cube_between(0, 4)), Relation::a_inside_b);
  EXPECT_EQ(relation(cube_between(0, 4), cube_between(0, 4)), Relation::meeting);
  EXPECT_EQ(relation(cube_between(0, 4), cube_between(1, 3), shift(1, 0, 0)), Relation::meeting);  // from within
  EXPECT_EQ(relation(cube_between(0, 4), cube_between(1, 3), shift(0, 3, 0)), Relation::meeting);  // from outside
  EXPECT_EQ(relation(cube_between(0, 4), cube_between(1, 3), shift(0, 0, 3.5)), Relation::none);
  EXPECT_EQ(
      relation(cube_between(1, 3), cube_between(0, 4), Pose::from_matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}, {4, 0, 0})),
      Relation::a_inside_b);  // mirrored
  // All of a flat one is boundary, and nothing is inside of it.
  const ConvexPolyhedron triangle = hull({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}});
  EXPECT_EQ(relation(cube_between(0, 4), triangle), Relation::b_inside_a);
  EXPECT_EQ(relation(triangle, triangle), Relation::meeting);
  EXPECT_EQ(relation(triangle, hull({{1.25, 1.25, 1}})), Relation::meeting);
  EXPECT_EQ(relation(cube_between(0, 4), hull({{1, 1, 0}})), Relation::meeting);
  EXPECT_EQ(relation(cube_between(0, 4), hull({{1, 1, 4}, {1, 1, std::nextafter(4.0, 5.0)}})), Relation::meeting);
}

TEST(PolyhedronPolyhedronBoundaryTest, AgreesWithTheScan) {
  const int count = tests::scaled_count(3000);
  tests::SolidPairs pairs(tests::chosen_seed(47));
  std::map<Relation, int> seen;
  for (int i = 0; i < count; ++i) {
    tests::PairCase c = i % 2 == 0 ? pairs.next(Family::contained) : pairs.next();
    if (i % 4 == 2) {
      std::swap(c.a, c.b);
      std::swap(c.pose_a, c.pose_b);
    }
    if (c.a.vertices().size() * c.b.vertices().size() > 20000) continue;
    const RelationAnswer answer = polyhedron_polyhedron_boundary(c.a, c.pose_a, c.b, c.pose_b);
    const RelationAnswer scan = polyhedron_polyhedron_boundary_by_scan(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(answer.relation, scan.relation) << i << " " << name_of(c.family);
    ++seen[scan.relation];
  }
  if (count < 1000) return;
  for (const Relation b : {Relation::none, Relation::meeting, Relation::a_inside_b, Relation::b_inside_a}) {
    EXPECT_GT(seen[b], count / 100) << name_of(b);
  }
}

// Linear, but for a logarithm, and no less.
TEST(PolyhedronPolyhedronBoundaryTest, ProbesGrowAsN) {
  Random random(tests::chosen_seed(48));
  for (std::uint32_t n = 100; n <= 10000; n *= 10) {
    const ConvexPolyhedron a(tests::points_on_sphere(n, random));
    const Pose twice = Pose::from_matrix({2, 0, 0, 0, 2, 0, 0, 0, 2}, {0, 0, 0});
    const RelationAnswer answer = polyhedron_polyhedron_boundary(a, Pose(), a, twice);
    EXPECT_EQ(answer.relation, Relation::a_inside_b);
    EXPECT_LE(answer.cost.probes, static_cast<std::uint64_t>(20 * n * std::log2(n)));
    EXPECT_GE(answer.cost.probes, n);
  }
}

}  // namespace
}  // namespace sunder::solid
