// Meshes of all kinds, closed, open, in pieces, touching to the last bit, under poses: whether two meet, down their trees
// against each triangle with each, and proofs of half of the answers; and how many boxes and triangles near ones take, over three decades.
#include <tests/support/mesh_proofs.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/mesh/mesh_cover.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <variant>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Mesh;
using solid::MeshAnswer;
using solid::MeshView;
using solid::Pose;

struct Soup {
  std::vector<Point3> points;
  std::vector<std::uint32_t> begin{0}, corners;

  void add_face(const std::vector<std::uint32_t>& face) {
    corners.insert(corners.end(), face.begin(), face.end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  // A box of this size, turned inwards or outwards, perhaps without a face.
  void add_box(const Point3& low, const Point3& size, bool outwards, bool is_open) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t k = 0; k < 8; ++k) {
      points.push_back({low.x + (k & 1 ? size.x : 0), low.y + (k & 2 ? size.y : 0), low.z + (k & 4 ? size.z : 0)});
    }
    const std::array<std::array<std::uint32_t, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (std::size_t f = is_open ? 1 : 0; f < 6; ++f) {
      std::vector<std::uint32_t> face;
      for (const std::uint32_t corner : faces[f]) face.push_back(first + corner);
      if (!outwards) std::reverse(face.begin(), face.end());
      add_face(face);
    }
  }
  Mesh mesh() const { return Mesh(MeshView{points, begin, corners}); }
};

// Some boxes with whole coordinates, and loose triangles.
Soup some_soup(Random& random) {
  Soup soup;
  const auto whole = [&](int low, int high) { return static_cast<double>(random.between(low, high)); };
  const std::uint64_t boxes = 1 + random.below(4);
  for (std::uint64_t k = 0; k < boxes; ++k) {
    soup.add_box({whole(-3, 3), whole(-3, 3), whole(-3, 3)}, {whole(1, 4), whole(1, 4), whole(1, 4)},
                 random.below(4) > 0, random.below(5) == 0);
  }
  const std::uint64_t loose = random.below(4);
  for (std::uint64_t k = 0; k < loose; ++k) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (int c = 0; c < 3; ++c) soup.points.push_back({whole(-4, 4), whole(-4, 4), whole(-4, 4)});
    soup.add_face({first, first + 1, first + 2});
  }
  return soup;
}

Pose soup_pose(Random& random, int i) {
  const auto whole = [&] { return static_cast<double>(random.between(-5, 5)); };
  std::array<double, 3> shift{whole(), whole(), whole()};
  if (i % 3 == 1) shift[random.below(3)] += std::ldexp(random.below(2) == 0 ? 1.0 : -1.0, -50);
  if (i % 3 == 2) {
    return Pose::from_quaternion(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 1, shift);
  }
  return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, shift);
}

// A 64th as large, somewhere.
Pose small_pose(Random& random) {
  return Pose::from_matrix({0x1p-6, 0, 0, 0, 0x1p-6, 0, 0, 0, 0x1p-6},
                           {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)});
}

TEST(MeshPairsDifferential, TreesAgreeWithTheScan) {
  Random random(chosen_seed(4011));
  const int times = scaled_count(1200);
  int meet = 0, within = 0;
  for (int i = 0; i < times; ++i) {
    const Mesh a = some_soup(random).mesh(), b = some_soup(random).mesh();
    const Pose pose_a = i % 2 == 0 ? Pose() : soup_pose(random, i),
               pose_b = i % 2 == 0 ? small_pose(random) : soup_pose(random, i);
    const MeshAnswer answer = mesh_mesh(a, pose_a, b, pose_b), scan = mesh_mesh_by_scan(a, pose_a, b, pose_b);
    ASSERT_EQ(answer.evidence.index(), scan.evidence.index()) << i;
    ASSERT_EQ(mesh_mesh(b, pose_b, a, pose_a).evidence.index(), scan.evidence.index()) << i;
    if (i % 2 == 1) proved_pair(a, pose_a, b, pose_b, answer);
    meet += scan.meet();
    within += std::holds_alternative<solid::PointWithin>(scan.evidence);
  }
  EXPECT_GE(meet, times / 20);
  EXPECT_LE(meet, times * 4 / 5);
  EXPECT_GE(within, times / 400);
}

// A sphere with bumps.
Mesh bumpy(std::size_t n, Random& random) {
  const ConvexPolyhedron sphere(solid_shapes::sphere(n, random));
  Soup soup;
  for (const Point3& p : sphere.vertices()) {
    const double size = 1 + 0.1 * std::sin(9 * p.x + 1) * std::sin(8 * p.y) * std::sin(10 * p.z + 2);
    soup.points.push_back({p.x * size, p.y * size, p.z * size});
  }
  for (std::uint32_t f = 0; f < sphere.facet_count(); ++f) {
    soup.add_face({sphere.facet(f).begin(), sphere.facet(f).end()});
  }
  return soup.mesh();
}

// Two spheres with bumps, apart by a two-thousandth of their size, deep in one another, and one in the other.
TEST(MeshPairsDifferential, LooksGrowAsALogarithm) {
  Random random(chosen_seed(4013));
  for (const std::size_t n : {100u, 1000u, 10000u, 50000u}) {
    const Mesh a = bumpy(n, random), b = bumpy(n, random);
    const int times = 20;
    double near = 0, deep = 0, within = 0;
    for (int i = 0; i < times; ++i) {
      const Point3 d = on_sphere(random);
      const double w = random.uniform(-1, 1), x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      const auto at = [&](double distance, double size) {
        std::array<double, 9> linear = Pose::from_quaternion(w, x, y, 1, {}).affine().linear;
        for (double& entry : linear) entry *= size;
        return Pose::from_matrix(linear, {distance * d.x, distance * d.y, distance * d.z});
      };
      double meeting = 1.5, apart = 2.5;
      while (apart - meeting > 1e-6) {
        const double middle = (meeting + apart) / 2;
        (mesh_mesh(a, Pose(), b, at(middle, 1)).meet() ? meeting : apart) = middle;
      }
      const MeshAnswer beside = mesh_mesh(a, Pose(), b, at(apart + 0.001, 1)),
                       overlap = mesh_mesh(a, Pose(), b, at(1.5, 1)), inner = mesh_mesh(a, Pose(), b, at(0.01, 0.5));
      EXPECT_FALSE(beside.meet());
      EXPECT_TRUE(overlap.meet());
      EXPECT_TRUE(std::holds_alternative<solid::PointWithin>(inner.evidence));
      near += static_cast<double>(beside.cost.probes) / times;
      deep += static_cast<double>(overlap.cost.probes) / times;
      within += static_cast<double>(inner.cost.probes) / times;
    }
    const double log_n = std::log2(static_cast<double>(n));
    std::printf("n %6zu: %8.0f probes near, %6.0f deep, %6.0f within; %.1f, %.1f, %.1f times log2 n\n", n, near, deep,
                within, near / log_n, deep / log_n, within / log_n);
    EXPECT_LE(near, 148 * log_n);
    EXPECT_LE(deep, 20 * log_n);
    EXPECT_LE(within, 38 * log_n);
  }
}

// Of two that are apart by the last bit of how far one is moved: how many planes are a cover?
TEST(MeshPairsDifferential, CoversAreShortToTheLastBit) {
  Random random(chosen_seed(4014));
  for (const std::size_t n : {100u, 1000u, 10000u}) {
    const Mesh a = bumpy(n, random), b = bumpy(n, random);
    const double log_n = std::log2(static_cast<double>(n));
    std::size_t most = 0;
    const int times = scaled_count(12);
    for (int i = 0; i < times; ++i) {
      const Point3 d = on_sphere(random);
      const double w = random.uniform(-1, 1), x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      const auto at = [&](double distance) {
        return Pose::from_quaternion(w, x, y, 1, {distance * d.x, distance * d.y, distance * d.z});
      };
      double meeting = 0, apart = 4;
      while (true) {
        const double middle = meeting + (apart - meeting) / 2;
        if (middle <= meeting || middle >= apart) break;
        (mesh_mesh(a, Pose(), b, at(middle)).meet() ? meeting : apart) = middle;
      }
      const Pose pose = at(apart);
      const solid::MeshCover cover = mesh_cover(a, Pose(), b, pose);
      most = std::max(most, cover.directions.size());
      if (n <= 1000) {
        proved_pair(a, Pose(), b, pose, mesh_mesh(a, Pose(), b, pose));
      }
    }
    std::printf("n %6zu: %zu planes at most, %.1f times log2 n\n", n, most, static_cast<double>(most) / log_n);
    EXPECT_LE(static_cast<double>(most), 22 * log_n);
  }
}

}  // namespace
}  // namespace sunder::tests
