// Meshes as they are, and bodies with a radius: down the tree against each triangle, with proofs, and to the last bit. And
// how many boxes and triangles that takes, over three decades.
#include <tests/support/mesh_proofs.h>
#include <tests/support/mesh_soups.h>
#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/mesh/mesh_round.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace sunder::tests {
namespace {

using solid::Mesh;
using solid::MeshRoundAnswer;
using solid::PlacedRound;
using solid::Pose;
using solid::RoundBody;

Pose some_turn(Random& random, double far) {
  return Pose::from_quaternion(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 1,
                               {random.uniform(-far, far), random.uniform(-far, far), random.uniform(-far, far)});
}

// What is proved, where it is decided.
std::string told(const MeshRoundAnswer& met, const MeshRoundAnswer& clearance) {
  const char* const first = std::holds_alternative<solid::RoundOnTriangle>(met.evidence)   ? "meet"
                            : std::holds_alternative<solid::RoundWithinMesh>(met.evidence) ? "b_within"
                                                                                           : "apart";
  const char* const second = std::holds_alternative<solid::RoundOnTriangle>(clearance.evidence)   ? "broken"
                             : std::holds_alternative<solid::RoundWithinMesh>(clearance.evidence) ? "b_within"
                                                                                                  : "kept";
  return std::string(first) + " " + second;
}

TEST(MeshRoundDifferential, TreesAgreeWithAllTriangles) {
  Random random(chosen_seed(4031));
  const int times = scaled_count(360, 120);
  int apart = 0, meeting = 0, within = 0, undecided = 0;
  for (int i = 0; i < times; ++i) {
    const auto primitive = static_cast<Primitive>(i % primitive_count);
    const Mesh mesh = some_soup(random).mesh();
    RoundBody body = some_primitive(primitive, random);
    if (random.below(3) == 0) body = RoundBody::ball({random.uniform(-2, 2), 0.5, 0.5}, 0x1p-4);
    const Pose pose = i % 2 == 0 ? Pose() : soup_pose(random, i),
               pose_body = i % 3 == 0 ? Pose() : some_turn(random, 3);
    const PlacedRound placed(body, pose_body);
    const MeshRoundAnswer found = mesh_round(mesh, pose, placed), all = mesh_round_by_scan(mesh, pose, placed);
    ASSERT_EQ(found.verdict(), all.verdict()) << i;
    ASSERT_EQ(std::holds_alternative<solid::RoundWithinMesh>(found.evidence),
              std::holds_alternative<solid::RoundWithinMesh>(all.evidence))
        << i;
    undecided += found.undecided() ? 1 : 0;
    if (!body.is_curved()) {
      ASSERT_FALSE(found.undecided()) << i;
    }
    const auto [distance, nearest, cost] = mesh_round_distance(mesh, pose, placed, found);
    const Interval of_all = mesh_round_distance_by_scan(mesh, pose, placed, found).distance;
    ASSERT_TRUE(distance.low <= distance.high && distance.low <= of_all.high && of_all.low <= distance.high) << i;
    ASSERT_LE(distance.high - distance.low, 0x1p-40 * 16) << i;
    ASSERT_TRUE(found.meet() == (distance.high == 0)) << i;
    apart += found.verdict() == Verdict::apart ? 1 : 0;
    meeting += std::holds_alternative<solid::RoundOnTriangle>(found.evidence) ? 1 : 0;
    within += std::holds_alternative<solid::RoundWithinMesh>(found.evidence) ? 1 : 0;
    const double beyond = std::nextafter(distance.high, 2 * distance.high + 1);
    for (const double least : {distance.low, beyond, 2 * distance.high, 0.25}) {
      if (!(least > 0)) continue;
      const MeshRoundAnswer clearance = mesh_round_clearance(mesh, pose, placed, least);
      ASSERT_EQ(clearance.verdict(), mesh_round_clearance_by_scan(mesh, pose, placed, least).verdict()) << i;
      if (least <= distance.low || least > distance.high) {
        ASSERT_EQ(clearance.verdict(), least <= distance.low ? Verdict::apart : Verdict::meet) << i << " " << least;
      }
      if (found.undecided() || clearance.undecided() || i % 2 == 1) continue;
      EXPECT_EQ(proved_beside(mesh, pose, placed, found, least, clearance), told(found, clearance)) << i;
    }
  }
  EXPECT_GE(apart, times / 12);
  EXPECT_GE(meeting, times / 12);
  EXPECT_GE(within, times / 200);
  EXPECT_LE(undecided, 1 + times / 100);
}

// A body goes along a line to the last double at which it meets the mesh, and to the next one: both are proved.
TEST(MeshRoundDifferential, ToTheLastBit) {
  Random random(chosen_seed(4032));
  const int times = scaled_count(72, 18);
  int decided = 0;
  for (int i = 0; i < times; ++i) {
    const auto primitive = static_cast<Primitive>(i % primitive_count);
    const Mesh mesh = i % 2 == 0 ? some_soup(random).mesh() : bumpy(30, random);
    const RoundBody body = some_primitive(primitive, random);
    const Pose turned = some_turn(random, 1);
    const Point3 way{40, 0x1p-3, -1};
    const auto verdict = [&](double t) {
      const Pose pose_body = moved(turned, way, t);
      return mesh_round(mesh, Pose(), PlacedRound(body, pose_body)).verdict();
    };
    double first = -1, last = 1;
    for (int k = 0; k < 40 && verdict(first) != Verdict::meet; ++k) first = random.uniform(-0.2, 0.2);
    if (verdict(first) != Verdict::meet) continue;
    for (double middle = (first + last) / 2; middle > first && middle < last; middle = (first + last) / 2) {
      (verdict(middle) == Verdict::meet ? first : last) = middle;
    }
    for (const double t : {first, last}) {
      const Pose pose_body = moved(turned, way, t);
      const PlacedRound placed(body, pose_body);
      const MeshRoundAnswer found = mesh_round(mesh, Pose(), placed);
      if (found.undecided()) continue;  // of curved bodies and triangles that is rare
      ++decided;
      EXPECT_EQ(proved_beside(mesh, Pose(), placed, found), t == first ? "meet" : "apart") << i;
    }
  }
  EXPECT_GE(decided, times / 2);
}

// Scaled by powers of two to the ends of the doubles, all is as before.
TEST(MeshRoundDifferential, OfAnySize) {
  Random random(chosen_seed(4033));
  const int times = scaled_count(40);
  for (int i = 0; i < times; ++i) {
    const Mesh mesh = some_soup(random).mesh();
    const Point3 from{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)}, to{from.x + 1, from.y, -1};
    const double radius = random.uniform(0, 2);
    const Pose here;
    const RoundBody capsule = RoundBody::capsule(from, to, radius);
    const PlacedRound body(capsule, here);
    const MeshRoundAnswer found = mesh_round(mesh, Pose(), body);
    for (const int k : {-1000, -300, 300, 900}) {
      const auto times_2k = [&](double x) { return std::ldexp(x, k); };
      const Pose smaller = Pose::from_matrix({times_2k(1), 0, 0, 0, times_2k(1), 0, 0, 0, times_2k(1)}, {0, 0, 0});
      const auto scaled = [&](const Point3& p) { return Point3{times_2k(p.x), times_2k(p.y), times_2k(p.z)}; };
      const RoundBody other = RoundBody::capsule(scaled(from), scaled(to), times_2k(radius));
      ASSERT_EQ(mesh_round(mesh, smaller, PlacedRound(other, here)).verdict(), found.verdict()) << i << " " << k;
    }
  }
}

// A ball, a capsule and a cylinder near a sphere with bumps, and far from it.
TEST(MeshRoundDifferential, LooksAreFew) {
  Random random(chosen_seed(4034));
  const std::array bodies{RoundBody::ball({}, 0.5), RoundBody::capsule({-1, 0, 0}, {1, 0, 0}, 0.25),
                          RoundBody::cylinder({-1, 0, 0}, {1, 0, 0}, 0.25)};
  for (const std::size_t n : {100u, 1000u, 10000u, 50000u}) {
    const Mesh mesh = bumpy(n, random);
    constexpr int times = 20;
    std::array<double, 3> probes{}, asked{};
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      for (int i = 0; i < times; ++i) {
        const Point3 d = on_sphere(random);
        const double w = random.uniform(-1, 1), x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        const auto at = [&](double t) { return Pose::from_quaternion(w, x, y, 1, {t * d.x, t * d.y, t * d.z}); };
        double meeting = 0, apart = 4;
        while (apart - meeting > 1e-6) {
          const double middle = (meeting + apart) / 2;
          const Pose there = at(middle);
          (mesh_round(mesh, Pose(), PlacedRound(bodies[b], there)).meet() ? meeting : apart) = middle;
        }
        const Pose near = at(apart + 0.001);
        const Cost cost = mesh_round(mesh, Pose(), PlacedRound(bodies[b], near)).cost;
        probes[b] += static_cast<double>(cost.probes) / times;
        asked[b] += static_cast<double>(cost.iterations) / times;
      }
    }
    const double log_n = std::log2(static_cast<double>(n));
    std::printf(
        "n %6zu: probes near a ball %.0f, a capsule %.0f, a cylinder %.0f; triangles asked about %.1f, %.1f, %.1f\n", n,
        probes[0], probes[1], probes[2], asked[0], asked[1], asked[2]);
    EXPECT_LE(probes[0], 20 * log_n);
    EXPECT_LE(probes[1], 20 * log_n);
  }
}

}  // namespace
}  // namespace sunder::tests
