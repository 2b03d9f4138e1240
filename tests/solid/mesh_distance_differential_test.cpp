// How far apart meshes are: down their trees against each triangle with each, which the scan of convex bodies decides; with
// proofs. And how many boxes and triangles that takes, over three decades.
#include <tests/support/mesh_proofs.h>
#include <tests/support/mesh_soups.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Mesh;
using solid::MeshDistance;
using solid::Pose;

std::vector<ConvexPolyhedron> triangles_of(const Mesh& mesh) {
  std::vector<ConvexPolyhedron> result;
  for (const Mesh::Triangle& t : mesh.triangles()) {
    result.emplace_back(std::array{mesh.points()[t[0]], mesh.points()[t[1]], mesh.points()[t[2]]});
  }
  return result;
}

// Of meshes that are apart, squared.
ExactFraction least_square(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b) {
  const std::vector<ConvexPolyhedron> of_a = triangles_of(a), of_b = triangles_of(b);
  std::optional<ExactFraction> least;
  for (const ConvexPolyhedron& t : of_a) {
    for (const ConvexPolyhedron& u : of_b) {
      const ExactFraction square = closest_of(polyhedron_polyhedron_distance_by_scan(t, pose_a, u, pose_b))->squared();
      if (!least || square < *least) least = square;
    }
  }
  return *least;
}

TEST(MeshDistanceDifferential, TreesAgreeWithAllPairs) {
  Random random(chosen_seed(4021));
  const int times = scaled_count(120);
  int apart = 0;
  for (int i = 0; i < times; ++i) {
    const Mesh a = some_soup(random).mesh(), b = some_soup(random).mesh();
    const Pose pose_a = i % 2 == 0 ? Pose() : soup_pose(random, i),
               pose_b = i % 2 == 0 ? small_pose(random) : soup_pose(random, i);
    const MeshDistance found = mesh_distance(a, pose_a, b, pose_b);
    ASSERT_EQ(found.meet(), mesh_mesh(a, pose_a, b, pose_b).meet()) << i;
    const solid::NearTriangles* const nearest = nearest_of(found);
    if (nearest == nullptr) {
      EXPECT_TRUE(are_meshes_closer(a, pose_a, b, pose_b, 0x1p-1000));
      EXPECT_EQ(distance_of(found).high, 0);
      continue;
    }
    ++apart;
    const ExactFraction square = nearest->closest.squared();
    ASSERT_EQ(square, least_square(a, pose_a, b, pose_b)) << i;
    if (i % 5 == 0) {
      ASSERT_EQ(square, nearest_of(mesh_distance_by_scan(a, pose_a, b, pose_b))->closest.squared()) << i;
    }
    ASSERT_EQ(square, nearest_of(mesh_distance(b, pose_b, a, pose_a))->closest.squared()) << i;
    const auto [low, high] = distance_of(found);
    for (const double least : {std::nextafter(low, 0.0), low, high, std::nextafter(high, 2 * high), 2 * high}) {
      if (least > 0) {
        ASSERT_EQ(are_meshes_closer(a, pose_a, b, pose_b, least), compare_distance(found, least) == Sign::negative)
            << i << " " << least;
      }
    }
    if (i % 3 == 0) {
      EXPECT_EQ(proved_measures(a, pose_a, b, pose_b, found, low), "closest kept") << i;
      EXPECT_EQ(proved_measures(a, pose_a, b, pose_b, found, 1.5 * high), "closest broken") << i;
    }
  }
  EXPECT_GE(apart, times / 5);
}

// Scaled by powers of two, the distance is that much larger; so near to the ends of the doubles, too. Where images are
// mirrored or sheared, it is as of all pairs.
TEST(MeshDistanceDifferential, OfAnySizeAndUnderAnyMap) {
  Random random(chosen_seed(4022));
  const int times = scaled_count(30);
  for (int i = 0; i < times; ++i) {
    const Mesh a = some_soup(random).mesh(), b = some_soup(random).mesh();
    const auto map = [&](double x) { return x * static_cast<double>(random.between(-2, 2)); };
    std::array<double, 9> linear{};
    for (double& entry : linear) entry = map(1);
    const auto row = [&](std::size_t k) { return Vector3<double>{linear[k], linear[k + 1], linear[k + 2]}; };
    if (dot(cross(row(0), row(3)), row(6)) == 0) continue;
    std::array<double, 3> shift{map(6), map(6), 7};
    const auto scaled = [&](int k, const std::array<double, 9>& of, const std::array<double, 3>& by) {
      std::array<double, 9> m = of;
      std::array<double, 3> t = by;
      for (double& entry : m) entry = std::ldexp(entry, k);
      for (double& entry : t) entry = std::ldexp(entry, k);
      return Pose::from_matrix(m, t);
    };
    constexpr std::array<double, 9> as_it_is{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const MeshDistance found = mesh_distance(a, Pose(), b, scaled(0, linear, shift));
    if (found.meet()) continue;
    const ExactFraction square = nearest_of(found)->closest.squared();
    ASSERT_EQ(square, least_square(a, Pose(), b, scaled(0, linear, shift))) << i;
    for (const int k : {-1000, -300, -150, 300, 900}) {
      const MeshDistance other = mesh_distance(a, scaled(k, as_it_is, {}), b, scaled(k, linear, shift));
      ASSERT_EQ((ExactFraction{square.numerator.scaled(2 * k), square.denominator}),
                nearest_of(other)->closest.squared())
          << i << " " << k;
      const double beyond = std::nextafter(distance_of(other).high, std::numeric_limits<double>::infinity());
      EXPECT_TRUE(are_meshes_closer(a, scaled(k, as_it_is, {}), b, scaled(k, linear, shift), beyond)) << i << " " << k;
    }
  }
}

// Two spheres with bumps: near contact; half of their size apart, where many bumps are about as near; and whether that is
// more than a quarter.
TEST(MeshDistanceDifferential, LooksAreFew) {
  Random random(chosen_seed(4023));
  for (const std::size_t n : {100u, 1000u, 10000u, 50000u}) {
    const Mesh a = bumpy(n, random), b = bumpy(n, random);
    constexpr int times = 20;
    double near = 0, far = 0, closer = 0;
    for (int i = 0; i < times; ++i) {
      const Point3 d = on_sphere(random);
      const double w = random.uniform(-1, 1), x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      const auto at = [&](double t) { return Pose::from_quaternion(w, x, y, 1, {t * d.x, t * d.y, t * d.z}); };
      const double apart = just_apart(a, b, at);
      near += static_cast<double>(mesh_distance(a, Pose(), b, at(apart + 0.001)).cost.probes) / times;
      far += static_cast<double>(mesh_distance(a, Pose(), b, at(apart + 1)).cost.probes) / times;
      Cost cost;
      EXPECT_FALSE(are_meshes_closer(a, Pose(), b, at(apart + 1), 0.5, &cost));
      closer += static_cast<double>(cost.probes) / times;
    }
    const double log_n = std::log2(static_cast<double>(n));
    std::printf("n %6zu: %8.0f probes near, %8.0f far, %6.0f for a bound; %.1f, %.1f, %.1f times log2 n\n", n, near,
                far, closer, near / log_n, far / log_n, closer / log_n);
    EXPECT_LE(near, 381 * log_n);
    EXPECT_LE(far, 203 * std::sqrt(static_cast<double>(n)));
    EXPECT_LE(closer, 6.8 * log_n);
  }
}

}  // namespace
}  // namespace sunder::tests
