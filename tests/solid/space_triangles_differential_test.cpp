// Triangles of space, of any shape, under poses: whether they meet, against the scan of two bodies of three points; and
// how segments cross them, against that and the turns of the corners in fractions.
#include <tests/support/fraction.h>
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/predicate/line/space_triangles.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;

using Corners = std::array<Point3, 3>;

// Of small whole numbers, so that they touch, are in one plane, on one line, or points; some a last bit away.
Corners some_triangle(Random& random, int range) {
  Corners corners;
  for (Point3& p : corners) {
    for (std::size_t c = 0; c < 3; ++c) p[c] = static_cast<double>(random.between(-range, range));
  }
  if (random.below(6) == 0) corners[1] = corners[0];
  if (random.below(6) == 0) {  // on one line
    for (std::size_t c = 0; c < 3; ++c) corners[2][c] = 2 * corners[1][c] - corners[0][c];
  }
  if (random.below(4) == 0) {
    Point3& p = corners[random.below(3)];
    const std::size_t c = random.below(3);
    p[c] = std::nextafter(p[c], random.below(2) == 0 ? 100 : -100);
  }
  return corners;
}

Pose triangle_pose(Random& random) {
  if (random.below(2) == 0) return {};
  while (true) {
    std::array<double, 9> linear;
    std::array<double, 3> shift;
    for (double& x : linear) x = static_cast<double>(random.between(-2, 2));
    for (double& x : shift) x = static_cast<double>(random.between(-2, 2)) / 4;
    try {
      return Pose::from_matrix(linear, shift);
    } catch (const Error&) {  // singular
    }
  }
}

PosedTriangle posed_of(const Corners& corners, const Pose& pose) {
  return {posed(corners[0], pose.affine()), posed(corners[1], pose.affine()), posed(corners[2], pose.affine())};
}

using Exact = std::array<Fraction, 3>;

Exact image_of(const Point3& p, const Pose& pose) {
  Exact result;
  for (std::size_t r = 0; r < 3; ++r) {
    result[r] = Fraction(pose.affine().translation[r]);
    for (std::size_t c = 0; c < 3; ++c) result[r] += Fraction(pose.affine().linear[3 * r + c]) * Fraction(p[c]);
  }
  return result;
}

int turn_of(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
  std::array<Exact, 3> v{};
  for (std::size_t k = 0; k < 3; ++k) v[k] = {b[k] - a[k], c[k] - a[k], d[k] - a[k]};
  const Fraction det = (v[1][0] * v[2][1] - v[2][0] * v[1][1]) * v[0][2] +
                       (v[2][0] * v[0][1] - v[0][0] * v[2][1]) * v[1][2] +
                       (v[0][0] * v[1][1] - v[1][0] * v[0][1]) * v[2][2];
  return det.sign();
}

TEST(SpaceTrianglesDifferential, MeetAsBodiesOfTheirCornersDo) {
  Random random(chosen_seed(4003));
  const int times = scaled_count(20000);
  int meet = 0, thin = 0;
  for (int i = 0; i < times; ++i) {
    const int range = i % 3 + 1;
    Corners t = some_triangle(random, range), u = some_triangle(random, range);
    if (i % 5 == 0) {  // in one plane
      for (Point3& p : t) p.z = 1;
      for (Point3& p : u) p.z = 1;
    }
    const Pose pose_t = triangle_pose(random), pose_u = i % 2 == 0 ? pose_t : triangle_pose(random);
    const ConvexPolyhedron a{std::vector<Point3>(t.begin(), t.end())}, b{std::vector<Point3>(u.begin(), u.end())};
    const bool expected = polyhedron_polyhedron_by_scan(a, pose_t, b, pose_u).meet();
    ASSERT_EQ(triangles_meet(posed_of(t, pose_t), posed_of(u, pose_u)), expected) << i;
    ASSERT_EQ(triangles_meet(posed_of(u, pose_u), posed_of(t, pose_t)), expected) << i;
    meet += expected;
    thin += a.dimension() < 2 || b.dimension() < 2;
  }
  EXPECT_GE(meet, times / 10);
  EXPECT_LE(meet, times * 9 / 10);
  EXPECT_GE(thin, times / 12);
}

TEST(SpaceTrianglesDifferential, SegmentsCrossAsTurnsSay) {
  Random random(chosen_seed(4005));
  const int times = scaled_count(20000);
  std::array<int, 4> seen{};
  for (int i = 0; i < times; ++i) {
    const Corners t = some_triangle(random, 2), ends = some_triangle(random, 2);
    const Pose pose_t = triangle_pose(random), pose_s = triangle_pose(random);
    const PosedTriangle segment = posed_of(ends, pose_s);
    const TriangleCrossing found = crossing_of(segment[0], segment[1], posed_of(t, pose_t));
    ++seen[static_cast<std::size_t>(found)];
    const Exact p = image_of(ends[0], pose_s), q = image_of(ends[1], pose_s), a = image_of(t[0], pose_t),
                b = image_of(t[1], pose_t), c = image_of(t[2], pose_t);
    const int of_p = turn_of(a, b, c, p), of_q = turn_of(a, b, c, q);
    const std::array around{turn_of(p, q, a, b), turn_of(p, q, b, c), turn_of(p, q, c, a)};
    const bool is_inner = of_p * of_q < 0 && around[0] != 0 && around[0] == around[1] && around[1] == around[2];
    const ConvexPolyhedron body{std::vector<Point3>(t.begin(), t.end())}, line{std::vector<Point3>{ends[0], ends[1]}};
    const bool meet = polyhedron_polyhedron_by_scan(body, pose_t, line, pose_s).meet();
    ASSERT_EQ(found == TriangleCrossing::none, !meet) << i;
    if (is_inner) {
      ASSERT_EQ(found, of_q > 0 ? TriangleCrossing::positive : TriangleCrossing::negative) << i;
    } else if (meet) {
      ASSERT_EQ(found, TriangleCrossing::touch) << i;
    }
  }
  for (const int count : seen) EXPECT_GE(count, times / 250);
}

}  // namespace
}  // namespace sunder::tests
