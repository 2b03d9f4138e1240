// How many boxes the nearest parts of a scene, and what meets on the way, look at.
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/sweep.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace sunder::scene {
namespace {

using solid::Pose;
using solid::RoundBody;

using Bodies = std::vector<Body>;

Part part(const RoundBody& shape, const Point3& at) { return {"", shape, tests::shift(at.x, at.y, at.z)}; }
const RoundBody& ball() {
  static const RoundBody made = RoundBody::ball({0, 0, 0}, 0.25);
  return made;
}
const RoundBody& rod() {
  static const RoundBody made = RoundBody::capsule({-1000, 0, 0}, {1000, 0, 0}, 0.125);
  return made;
}

Point3 anywhere(double side, Random& random) {
  return {random.uniform(0, side), random.uniform(0, side), random.uniform(0, side)};
}

// Small balls, about one in a unit of volume.
Bodies spread(std::size_t n, Random& random) {
  Bodies bodies(n);
  for (Body& body : bodies) body.parts = {part(ball(), anywhere(std::cbrt(static_cast<double>(n)), random))};
  return bodies;
}

// All in one layer, so that every axis but one sees a crowd; and in one column.
Bodies layer(std::size_t n, Random& random) {
  Bodies bodies(n);
  const double side = std::sqrt(static_cast<double>(n));
  for (Body& body : bodies) body.parts = {part(ball(), {random.uniform(0, side), random.uniform(0, side), 0})};
  return bodies;
}
Bodies column(std::size_t n, Random& random) {
  Bodies bodies(n);
  for (Body& body : bodies) body.parts = {part(ball(), {0, random.uniform(0, static_cast<double>(n)), 0})};
  return bodies;
}

// Rods that are much longer than they are apart.
Bodies rods(std::size_t n, Random& random) {
  Bodies bodies(n);
  const double side = std::sqrt(static_cast<double>(n));
  for (Body& body : bodies) {
    body.parts = {part(rod(), {random.uniform(0, 1), random.uniform(0, side), random.uniform(0, side)})};
  }
  return bodies;
}

// Clusters of 32, each within what is between the clusters by 2^20.
Bodies clusters(std::size_t n, Random& random) {
  Bodies bodies(n);
  Point3 middle{};
  for (std::size_t i = 0; i < n; ++i) {
    if (i % 32 == 0) middle = anywhere(0x1p20 * std::cbrt(static_cast<double>(n)), random);
    const Point3 at = anywhere(4, random);
    bodies[i].parts = {part(ball(), {middle.x + at.x, middle.y + at.y, middle.z + at.z})};
  }
  return bodies;
}

// Each nearer to the last than half of them.
Bodies ever_nearer(std::size_t n, Random&) {
  Bodies bodies(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double k = static_cast<double>(i), m = static_cast<double>(n);
    bodies[i].parts = {part(RoundBody::ball({0, 0, 0}, 1e-30), {std::exp2(-60 * k / m), 0, 0})};
  }
  return bodies;
}

// A long rod through them all, whose box holds everything, and which meets hardly any.
Bodies with_a_huge_one(std::size_t n, Random& random) {
  Bodies bodies = spread(n, random);
  const double side = std::cbrt(static_cast<double>(n));
  bodies[n / 2].parts = {part(RoundBody::capsule({0, 0, 0}, {side, side, side}, 0x1p-10), {0, 0, 0})};
  return bodies;
}

// Two bodies, far apart, of parts that lie on each other.
Bodies two_heaps(std::size_t n, Random& random) {
  Bodies bodies(2);
  for (std::size_t i = 0; i < n; ++i) {
    Point3 at = anywhere(0.25, random);
    if (i % 2 == 0) at.x += 1000;
    bodies[i % 2].parts.push_back(part(ball(), at));
    bodies[i % 2].parts.back().name = std::to_string(i);
  }
  return bodies;
}

Bodies moved(const Bodies& bodies, double by, Random& random) {
  Bodies end = bodies;
  for (Body& body : end) {
    for (Part& one : body.parts) {
      const auto& at = one.pose.affine().translation;
      const Point3 step = anywhere(by, random);
      one.pose = tests::shift(at[0] + step.x, at[1] + step.y, at[2] + step.z);
    }
  }
  return end;
}

struct Family {
  const char* name;
  Bodies (*make)(std::size_t, Random&);
};
constexpr Family families[] = {{"spread", spread},
                               {"layer", layer},
                               {"column", column},
                               {"rods", rods},
                               {"clusters", clusters},
                               {"ever nearer", ever_nearer},
                               {"a huge one", with_a_huge_one},
                               {"two heaps", two_heaps}};

constexpr std::size_t fewest = 1000, most = 32000;

double per_part(std::uint64_t looks, std::size_t n) { return static_cast<double>(looks) / static_cast<double>(n); }

// A search of a tree for each part: its depth, and a few leaves. One look at each pair would be 15 n at 32,000.
double bound(std::size_t n) { return 60 + 24 * std::log2(static_cast<double>(n)); }

TEST(SceneLooks, OfTheNearestPartsGrowAsNLogN) {
  for (const Family& family : families) {
    for (std::size_t n = fewest; n <= most; n *= 2) {
      Random random(n);
      std::uint64_t looks = 0;
      ASSERT_TRUE(nearest_parts(family.make(n, random), {}, &looks));
      EXPECT_GE(looks, n) << family.name;
      EXPECT_LE(per_part(looks, n), bound(n)) << family.name << " " << n;
    }
  }
}

TEST(SceneLooks, OnTheWayGrowAsNLogN) {
  for (const Family& family : families) {
    for (std::size_t n = fewest; n <= most; n *= 2) {
      Random random(n);
      const Bodies begin = family.make(n, random), end = moved(begin, 0.125, random);
      if (family.make == ever_nearer) continue;  // they meet, nearly all, on the way
      const SweptAnswer answer = meeting_on_the_way(begin, end);
      EXPECT_GE(answer.counts.looks, n) << family.name;
      EXPECT_LE(per_part(answer.counts.looks, n), bound(n)) << family.name << " " << n;
    }
  }
}

}  // namespace
}  // namespace sunder::scene
