// Points and boxes of a placed mesh against the exact images of its points.
#include <sunder/solid/mesh/placed_plane.h>

#include <sunder/base/random.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/mesh/mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace sunder::solid {
namespace {

Mesh some_mesh(Random& random, bool is_of_grid, double size) {
  std::vector<Point3> points;
  std::vector<std::uint32_t> begin{0}, corners;
  for (std::uint32_t k = 0; k < 60; ++k) {
    Point3 p = k == 0 ? Point3{} : points.back();
    for (std::size_t c = 0; c < 3; ++c) {
      p[c] += size * (is_of_grid ? static_cast<double>(random.between(-1, 1)) : random.uniform(-0.3, 0.3));
    }
    points.push_back(p);
    if (k < 2) continue;
    corners.insert(corners.end(), {k - 2, k - 1, k});
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return Mesh(MeshView{points, begin, corners});
}

Sign exact_side(const ExactPlane& plane, const Posed3& p) {
  return (dot(plane.normal, coordinates<Dyadic>(p)) - plane.offset).sign();
}

TEST(PlacedPlane, PointsAndBoxesAreWhereTheirExactImagesAre) {
  Random random(5201);
  int zeros = 0, sure = 0, boxes = 0, exact = 0, points = 0;
  for (int i = 0; i < 300; ++i) {
    const double size = i % 5 == 0 ? 1e-160 : i % 5 == 1 ? 1e140 : 1;
    const Mesh mesh = some_mesh(random, i % 2 == 0, size);
    std::array<double, 9> linear{1, 0, 0, 0, 1, 0, 0, 0, 1};
    if (i % 3 != 0) {
      for (double& x : linear) x = static_cast<double>(random.between(-3, 3)) + (i % 3 == 1 ? random.unit() : 0);
    }
    Pose pose;
    try {
      pose = Pose::from_matrix(linear, {size * static_cast<double>(random.between(-1, 1)), 0, size * random.unit()});
    } catch (const Error&) {  // singular
      continue;
    }
    const PlacedMesh placed(mesh, pose);
    const PosedTriangle t = placed.triangle(static_cast<std::uint32_t>(random.below(mesh.triangles().size())));
    const ExactPlane plane =
        i % 4 == 0
            ? ExactPlane::across_axis(random.below(3), size * static_cast<double>(random.between(-1, 1)))
            : ExactPlane::through(coordinates<Dyadic>(t[0]), coordinates<Dyadic>(t[1]), coordinates<Dyadic>(t[2]));
    if (plane.has_no_normal()) continue;
    const PlacedPlane seen(plane.seen_from(pose.affine()), placed);
    StageTally tally;
    for (std::uint32_t k = 0; k < mesh.points().size(); ++k) {
      const Sign found = seen.side_of(mesh.points()[k], &tally);
      ASSERT_EQ(found, exact_side(plane, placed.at(k))) << i << " " << k;
      zeros += found == Sign::zero;
      ++points;
    }
    exact += static_cast<int>(tally.exact);
    for (std::size_t node = 1; node < 2 * mesh.tree().leaves(); ++node) {
      const Guess side = seen.side_of(mesh.tree().box(node));
      ++boxes;
      if (!is_sure(side)) continue;
      ++sure;
      const auto [first, end] = mesh.tree().triangles(node);
      for (std::uint32_t k = first; k < end; ++k) {
        for (const std::uint32_t corner : mesh.triangles()[k]) {
          ASSERT_EQ(exact_side(plane, placed.at(corner)), to_sign(side)) << i << " " << node;
        }
      }
    }
  }
  EXPECT_GT(zeros, 500);
  EXPECT_GT(sure, boxes / 10);
  EXPECT_LT(exact, points / 4);
}

// Across an axis nothing is rounded, so nothing is left to exact numbers.
TEST(PlacedPlane, AcrossAnAxisFloatingPointDecides) {
  Random random(5202);
  const Mesh mesh = some_mesh(random, true, 1);
  const Pose pose;
  const PlacedMesh placed(mesh, pose);
  const PlacedPlane seen(ExactPlane::across_axis(1, 1), placed);
  StageTally tally;
  int zeros = 0;
  for (const Point3& p : mesh.points()) zeros += seen.side_of(p, &tally) == Sign::zero;
  EXPECT_GT(zeros, 0);
  EXPECT_EQ(tally.exact, 0u);
}

}  // namespace
}  // namespace sunder::solid
