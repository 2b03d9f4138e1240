// Meshes of all kinds, closed, open, in pieces, touching to the last bit, under poses: whether two meet, down their trees
// against each triangle with each, and proofs of half of the answers; and how many boxes and triangles near ones take, over three decades.
#include <tests/support/mesh_proofs.h>
#include <tests/support/mesh_soups.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/mesh/mesh_cover.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_point.h>

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

using solid::Mesh;
using solid::MeshAnswer;
using solid::Pose;

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
      const double apart = just_apart(a, b, [&](double t) { return at(t, 1); });
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
