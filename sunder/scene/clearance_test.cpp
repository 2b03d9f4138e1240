#include <sunder/base/random.h>
#include <sunder/scene/clearance.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace sunder::scene {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;
using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

Key key(const PartDistance& p) { return {p.body_a, p.body_b, p.part_a, p.part_b}; }

// Cubes on a lattice of quarters, many of them exactly so far apart as is asked; or anything.
std::vector<Body> random_bodies(Random& random, bool lattice) {
  std::vector<Body> bodies(2 + random.below(10));
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  for (Body& body : bodies) {
    for (std::uint64_t i = random.below(3); i > 0; --i) {
      const auto u = [&] { return random.uniform(-1, 1); };
      const auto n = [&] { return static_cast<double>(random.between(-10, 10)) / 4; };
      body.parts.push_back(lattice ? Part{"", cube, tests::shift(n(), n(), n())}
                                   : Part{"", ConvexPolyhedron(tests::points_in_cube(1 + random.below(20), random)),
                                          Pose::from_quaternion(u(), u(), u(), 1, {4 * u(), 4 * u(), 4 * u()})});
    }
  }
  return bodies;
}

void compare_with_all_pairs(bool lattice, std::uint64_t seed) {
  Random random(tests::chosen_seed(seed));
  std::uint64_t closer = 0, exactly = 0, by_boxes = 0, own = 0, apart = 0, ties = 0;
  const int rounds = tests::scaled_count(100, 30);
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Body> bodies = random_bodies(random, lattice);
    const auto some_body = [&] { return static_cast<std::uint32_t>(random.below(bodies.size())); };
    ClearanceQuestion question;
    question.least = lattice ? 0.25 * static_cast<double>(1 + random.below(4)) : random.uniform(0.01, 1);
    for (std::uint64_t i = random.below(3); i > 0; --i) {
      question.margins.push_back({some_body(), some_body(), lattice ? 1.5 : random.uniform(0.01, 3)});
    }
    if (random.below(2) == 0) question.allowed.push_back({some_body(), some_body()});

    std::vector<Key> expected;
    std::optional<PartDistance> nearest;
    std::uint64_t pairs = 0, allowed = 0;
    for (std::uint32_t a = 0; a < bodies.size(); ++a) {
      for (std::uint32_t b = a + 1; b < bodies.size(); ++b) {
        double least = question.least;
        for (const auto& [x, y, z] : question.margins) {
          if (std::minmax(x, y) == std::minmax(a, b)) least = z;
        }
        bool is_allowed = false;
        for (const auto& [x, y] : question.allowed) is_allowed = is_allowed || std::minmax(x, y) == std::minmax(a, b);
        for (std::uint32_t i = 0; i < bodies[a].parts.size(); ++i) {
          for (std::uint32_t j = 0; j < bodies[b].parts.size(); ++j) {
            ++pairs;
            allowed += is_allowed;
            if (is_allowed) continue;
            const Part &p = bodies[a].parts[i], &q = bodies[b].parts[j];
            auto distance =
                solid::polyhedron_polyhedron_distance_by_scan(p.shape.core(), p.pose, q.shape.core(), q.pose);
            const Sign sign = compare_distance(distance, least);
            if (sign == Sign::negative) expected.emplace_back(a, b, i, j);
            exactly += sign == Sign::zero;
            own += least != question.least;
            const double d = distance.distance().low, e = nearest ? nearest->distance.low : HUGE_VAL;
            ties += nearest && d == e;
            if (d < e) nearest = PartDistance{a, b, i, j, 0, distance.distance(), distance.closest};
          }
        }
      }
    }
    const ClearanceAnswer answer = closer_pairs(bodies, question);
    std::vector<Key> found;
    for (const PartDistance& p : answer.closer) found.push_back(key(p));
    ASSERT_EQ(found, expected) << seed << " " << round;
    ASSERT_EQ(answer.pairs, pairs);
    ASSERT_EQ(answer.allowed, allowed);
    ASSERT_EQ(answer.pairs, answer.allowed + answer.by_boxes + answer.by_method);
    closer += found.size();
    by_boxes += answer.by_boxes;

    const std::optional<PartDistance> of_scene = nearest_parts(bodies, question.allowed);
    ASSERT_EQ(of_scene.has_value(), nearest.has_value());
    if (!of_scene) continue;
    ASSERT_EQ(of_scene->distance.low, nearest->distance.low) << seed << " " << round;
    if (lattice) {  // distances are doubles, or far apart: equal ones are equal exactly
      ASSERT_EQ(key(*of_scene), key(*nearest)) << seed << " " << round;
    }
    apart += !of_scene->meet();
  }
  const auto some = static_cast<std::uint64_t>(rounds);
  EXPECT_GT(closer, some / 4);
  EXPECT_GT(by_boxes, some / 4);
  EXPECT_GT(own, some / 20);
  EXPECT_GT(apart, some / 30);
  if (lattice) {
    EXPECT_GT(exactly, some / 8);
    EXPECT_GT(ties, some / 20);
  }
}

TEST(Clearance, IsAllPairsInGeneralPosition) { compare_with_all_pairs(false, 81); }
TEST(Clearance, IsAllPairsOnALattice) { compare_with_all_pairs(true, 82); }

// Two cubes at the margin, and a last bit to either side.
TEST(Clearance, TellsTheLastBit) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  for (int bit = -4; bit <= 4; ++bit) {
    const std::vector<Body> bodies{{"a", {{"", cube, Pose()}}},
                                   {"b", {{"", cube, tests::shift(1.25 + bit * 0x1p-52, 0, 0)}}}};
    EXPECT_EQ(closer_pairs(bodies, {0.25, {}, {}}).closer.size(), bit < 0 ? 1u : 0u) << bit;
    EXPECT_EQ(closer_pairs(bodies, {1e-300, {{1, 0, 0.25}}, {}}).closer.size(), bit < 0 ? 1u : 0u) << bit;
  }
}

TEST(Clearance, FarPairsCostNothing) {
  std::vector<Body> bodies;
  for (int i = 0; i < 500; ++i)
    bodies.push_back({"", {{"", ConvexPolyhedron(tests::cube_corners(0, 1)), tests::shift(0, 3 * i, 0)}}});
  EXPECT_EQ(closer_pairs(bodies, {1.5, {}, {}}).by_method, 0u);
  EXPECT_EQ(closer_pairs(bodies, {2.5, {}, {}}).closer.size(), 499u);
  EXPECT_EQ(key(*nearest_parts(bodies)), (Key{0, 1, 0, 0}));
  EXPECT_FALSE(nearest_parts(std::span(bodies).first(1)));
}

}  // namespace
}  // namespace sunder::scene
