#include <sunder/solid/mesh/near_triangles.h>
#include <sunder/solid/mesh/placed_boxes.h>
#include <sunder/solid/mesh/placed_triangles.h>

#include <sunder/base/random.h>
#include <sunder/predicate/line/space_triangles.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace sunder::solid {
namespace {

// Triangles of this size about a middle; the first corner of the first one is there.
Mesh some_mesh(Random& random, const Point3& middle, double size, std::size_t triangles, bool is_flat) {
  std::vector<Point3> points;
  std::vector<std::uint32_t> begin{0}, corners;
  for (std::size_t t = 0; t < triangles; ++t) {
    const double part = random.uniform(0.01, 1);
    for (int k = 0; k < 3; ++k) {
      Point3 p = middle;
      for (std::size_t c = 0; c < 3 && !points.empty(); ++c) {
        p[c] += part * size * random.uniform(-1, 1) * (is_flat && c == 2 ? 1e-9 : 1);
      }
      corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p);
    }
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return Mesh(MeshView{points, begin, corners});
}

Pose some_pose(Random& random, int kind) {
  const double far = kind % 4 == 0 ? 0 : kind % 4 == 1 ? 10 : kind % 4 == 2 ? 1e7 : 1e-7;
  const std::array<double, 3> shift{far * random.uniform(-1, 1), far * random.uniform(-1, 1),
                                    far * random.uniform(-1, 1)};
  if (kind % 3 == 0) {
    return Pose::from_quaternion(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 1, shift);
  }
  std::array<double, 9> linear;
  for (double& x : linear)
    x = random.uniform(-1, 1) * (kind % 3 == 1 ? 1 : std::ldexp(1.0, static_cast<int>(random.between(-30, 30))));
  return Pose::from_matrix(linear, shift);
}

// Two meshes that have a point in common, exactly, whatever the pose of both is: no two nodes that have it are apart.
TEST(PlacedBoxes, WhatHasACommonPointIsNeverApart) {
  Random random(5201);
  for (int i = 0; i < 400; ++i) {
    const double away = i % 5 == 0 ? 1e9 : 1;
    const Point3 at{away * random.uniform(-1, 1), away * random.uniform(-1, 1), away * random.uniform(-1, 1)};
    const double ratio = std::ldexp(1.0, static_cast<int>(random.between(-25, 25)));
    const Mesh a = some_mesh(random, at, 1, 40, i % 2 == 0), b = some_mesh(random, at, ratio, 40, i % 3 == 0);
    const Pose pose = some_pose(random, i);
    const PlacedMesh placed_a(a, pose), placed_b(b, pose);
    const PlacedBoxes boxes(BoxFrame::of(placed_a), BoxFrame::of(placed_b));
    const auto leaf_of = [&](const Mesh& mesh) {
      for (std::uint32_t t = 0;; ++t) {
        for (const std::uint32_t corner : mesh.triangles()[t]) {
          if (mesh.points()[corner] == at) return std::pair(mesh.tree().leaf_of(t), t);
        }
      }
    };
    const auto [leaf_a, t] = leaf_of(a);
    const auto [leaf_b, u] = leaf_of(b);
    for (std::size_t node_a = leaf_a; node_a > 0; node_a /= 2) {
      for (std::size_t node_b = leaf_b; node_b > 0; node_b /= 2) {
        EXPECT_FALSE(boxes.are_apart(a.tree().box(node_a), b.tree().box(node_b))) << i;
      }
    }
    const auto flat_box = [](const Mesh& mesh, std::uint32_t triangle) {
      const auto corner = [&](std::size_t k) { return mesh.points()[mesh.triangles()[triangle][k]]; };
      return mesh.tree().box_around_triangle({corner(0), corner(1), corner(2)});
    };
    EXPECT_FALSE(boxes.are_apart(flat_box(a, t), flat_box(b, u))) << i;
    LeafTriangles of_a(placed_a), of_b(placed_b);
    of_a.take(leaf_a);
    of_b.take(leaf_b);
    EXPECT_FALSE(TrianglesApart(placed_a, placed_b)(of_a[t], of_b[u])) << i;
    // A segment that ends there.
    const PlacedBoxes along(BoxFrame::of(placed_a), BoxFrame::of(placed_b.at(at), placed_b.at(b.points()[0])));
    for (std::size_t node_a = leaf_a; node_a > 0; node_a /= 2) {
      EXPECT_FALSE(along.are_apart(a.tree().box(node_a), BoxFrame::segment_box())) << i;
    }
  }
}

// Of leaves that are said to be apart no two triangles meet; and of those that have no point in common most are said to
// be.
TEST(PlacedBoxes, ApartMeansThatNoTrianglesMeet) {
  Random random(5202);
  int apart = 0, pairs = 0, meeting = 0;
  for (int i = 0; i < 60; ++i) {
    const Mesh a = some_mesh(random, {}, 1, 30, i % 2 == 0), b = some_mesh(random, {0.5, 0, 0}, 1, 30, i % 3 == 0);
    const Pose pose_a = some_pose(random, 3 * i), pose_b = some_pose(random, i % 2 == 0 ? 3 * i : i);
    const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
    const PlacedBoxes boxes(BoxFrame::of(placed_a), BoxFrame::of(placed_b));
    const TrianglesApart are_apart(placed_a, placed_b);
    LeafTriangles of_a(placed_a), of_b(placed_b);
    for (std::size_t leaf_a = a.tree().leaves(); leaf_a < 2 * a.tree().leaves(); ++leaf_a) {
      for (std::size_t leaf_b = b.tree().leaves(); leaf_b < 2 * b.tree().leaves(); ++leaf_b) {
        const bool said = boxes.are_apart(a.tree().box(leaf_a), b.tree().box(leaf_b));
        const TriangleRange in_a = of_a.take(leaf_a), in_b = of_b.take(leaf_b);
        for (std::uint32_t t = in_a.first; t < in_a.end; ++t) {
          for (std::uint32_t u = in_b.first; u < in_b.end; ++u) {
            const bool meet = triangles_meet(placed_a.triangle(t), placed_b.triangle(u));
            EXPECT_FALSE(meet && (said || are_apart(of_a[t], of_b[u]))) << i;
            pairs += !meet;
            meeting += meet;
            apart += !meet && are_apart(of_a[t], of_b[u]);
          }
        }
      }
    }
  }
  EXPECT_GT(meeting, 100);
  EXPECT_GT(apart, pairs * 99 / 100);
}

// Bounds of boxes, along their own axes and along any direction, are no greater than the distance of any two triangles in
// them; what is told of two triangles encloses theirs. And most bounds are no less than a third of it.
TEST(PlacedBoxes, BoundsOfDistancesHold) {
  Random random(5204);
  int tight = 0, boxes_apart = 0;
  for (int i = 0; i < 24; ++i) {
    const Mesh a = some_mesh(random, {}, 1, 12, i % 2 == 0),
               b = some_mesh(random, {random.uniform(1, 9), 0, 0}, 1, 12, i % 3 == 0);
    const Pose pose_a = some_pose(random, i % 4 == 0 ? 3 : 3 * i), pose_b = some_pose(random, i % 2 == 0 ? 0 : i);
    const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
    const BoxFrame frame_a = BoxFrame::of(placed_a), frame_b = BoxFrame::of(placed_b);
    const PlacedBoxes boxes(frame_a, frame_b);
    Point3 d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (i % 3 == 0) {
      for (std::size_t c = 0; c < 3; ++c) d[c] = frame_b.middle[c] - frame_a.middle[c];
    }
    const double length = std::sqrt(dot(d, d));
    d = {d.x / length, d.y / length, d.z / length};
    const BoxesAlong along(frame_a, frame_b, d);
    const TriangleGaps gaps(placed_a, placed_b);
    LeafTriangles of_a(placed_a), of_b(placed_b);
    const auto hull_of = [](const Mesh& mesh, std::uint32_t t) {
      const Mesh::Triangle& corners = mesh.triangles()[t];
      return ConvexPolyhedron(
          std::array{mesh.points()[corners[0]], mesh.points()[corners[1]], mesh.points()[corners[2]]});
    };
    for (std::size_t leaf_a = a.tree().leaves(); leaf_a < 2 * a.tree().leaves(); ++leaf_a) {
      for (std::size_t leaf_b = b.tree().leaves(); leaf_b < 2 * b.tree().leaves(); ++leaf_b) {
        const TriangleRange in_a = of_a.take(leaf_a), in_b = of_b.take(leaf_b);
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t t = in_a.first; t < in_a.end; ++t) {
          for (std::uint32_t u = in_b.first; u < in_b.end; ++u) {
            const Interval exact =
                distance_of(polyhedron_polyhedron_distance(hull_of(a, t), pose_a, hull_of(b, u), pose_b));
            const TriangleGap gap = gaps(of_a[t], of_b[u], std::numeric_limits<double>::infinity());
            EXPECT_LE(gap.distance.low, exact.high) << i;
            EXPECT_GE(gap.distance.high, exact.low) << i;
            EXPECT_LE(gap.distance.high - gap.distance.low, 1e-9 * gap.distance.high + 1e-6 * exact.high + 1e-4) << i;
            EXPECT_LE(gaps.along(d, of_a[t], of_b[u]), exact.high) << i;
            least = std::min(least, exact.high);
          }
        }
        for (std::size_t up_a = leaf_a, up_b = leaf_b; up_a > 0 && up_b > 0; up_a /= 2, up_b /= 2) {
          const double bound = boxes.at_least(a.tree().box(up_a), b.tree().box(up_b));
          EXPECT_LE(bound, least) << i;
          EXPECT_LE(along.at_least(a.tree().box(up_a), b.tree().box(up_b)), least) << i;
          ++boxes_apart;
          tight += 3 * bound >= least;
        }
      }
    }
  }
  EXPECT_GT(tight, boxes_apart / 2);
}

// Boxes are as tight far from the origin as near it.
TEST(PlacedBoxes, AreTightFarFromTheOrigin) {
  Random near_random(5203), far_random(5203);
  const Mesh near = some_mesh(near_random, {}, 1, 200, false),
             far = some_mesh(far_random, {0x1p33, -0x1p33, 0x1p33}, 1, 200, false);
  for (std::size_t node = 1; node < 2 * near.tree().leaves(); ++node) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(near.tree().box(node).half[k], far.tree().box(node).half[k], 1e-3) << node;
    }
  }
}

}  // namespace
}  // namespace sunder::solid
