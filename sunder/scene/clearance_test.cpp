#include <sunder/base/random.h>
#include <sunder/scene/clearance.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_round.h>

#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::scene {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;
using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

Key distance_key(const PartDistance& p) { return {p.body_a, p.body_b, p.part_a, p.part_b}; }

// Cubes on a lattice of quarters, many of them exactly so far apart as is asked; or anything.
std::vector<Body> bodies_to_clear(Random& random, bool lattice) {
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

void compare_distances_of_all_pairs(bool lattice, std::uint64_t seed) {
  Random random(tests::chosen_seed(seed));
  std::uint64_t closer = 0, exactly = 0, by_boxes = 0, own = 0, apart = 0, ties = 0;
  const int rounds = tests::scaled_count(100, 30);
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Body> bodies = bodies_to_clear(random, lattice);
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
            const double d = distance_of(distance).low, e = nearest ? nearest->distance.low : HUGE_VAL;
            ties += nearest && d == e;
            if (d < e) nearest = PartDistance{a, b, i, j, distance_of(distance)};
          }
        }
      }
    }
    const ClearanceAnswer answer = closer_pairs(bodies, question);
    std::vector<Key> found;
    for (const PartDistance& p : answer.closer) found.push_back(distance_key(p));
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
      ASSERT_EQ(distance_key(*of_scene), distance_key(*nearest)) << seed << " " << round;
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

TEST(Clearance, IsAllPairsInGeneralPosition) { compare_distances_of_all_pairs(false, 81); }
TEST(Clearance, IsAllPairsOnALattice) { compare_distances_of_all_pairs(true, 82); }

solid::RoundBody random_shape(Random& random, bool curved) {
  const auto n = [&](double from, double to) { return random.uniform(from, to); };
  const auto radius = [&] { return 0.25 * static_cast<double>(1 + random.below(3)); };
  switch (random.below(curved ? 6 : 3)) {
    case 0: return solid::RoundBody::ball({0, 0, 0}, radius());
    case 1: return solid::RoundBody::capsule({0, 0, -0.5}, {0, 0, 0.5}, radius());
    case 2:
      return solid::RoundBody::rounded(ConvexPolyhedron(tests::cube_corners(0, 0.5)),
                                       0.25 * static_cast<double>(random.below(2)));
    case 3: return solid::RoundBody::cylinder({0, 0, -0.5}, {0, 0, 0.5}, n(0.1, 0.7));
    case 4: return solid::RoundBody::cone({0, 0, -0.5}, {0, 0, 0.5}, n(0.1, 0.7));
    default: return solid::RoundBody::ellipsoid({0, 0, 0}, {n(0.2, 0.7), n(0.2, 0.7), n(0.2, 0.7)});
  }
}

// A scene may list many pairs: the evidence of none is larger than the features of two polyhedra with their radii.
TEST(Clearance, APairThatIsListedIsSmall) {
  EXPECT_LE(sizeof(PartDistance), sizeof(solid::ClosestFeatures) + 64);
  EXPECT_LE(sizeof(CloserParts), 376u);
}

// Against round_clearance and round_distance of each pair. On a lattice many are exactly so far apart as is asked, and
// many as far as others.
void compare_with_all_round_pairs(bool curved, std::uint64_t seed) {
  Random random(tests::chosen_seed(seed));
  int closer = 0, exactly = 0, ties = 0, by_boxes = 0;
  const int rounds = tests::scaled_count(100, 10);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Body> bodies(4 + random.below(4));
    const double size = 3;
    for (Body& body : bodies) {
      const auto u = [&] { return random.uniform(-1, 1); };
      const auto n = [&] { return static_cast<double>(random.between(-8, 8)) / 2; };
      body.parts.push_back({"", random_shape(random, curved),
                            curved ? Pose::from_quaternion(u(), u(), u(), 1, {size * u(), size * u(), size * u()})
                                   : tests::shift(n(), 0, random.below(4) == 0 ? n() : 0)});
    }
    const double least = curved ? random.uniform(0.1, 2) : 0.5 * static_cast<double>(1 + random.below(3));
    std::vector<Key> expected;
    std::optional<std::pair<Key, Interval>> nearest;
    double low = HUGE_VAL;
    for (std::uint32_t a = 0; a < bodies.size(); ++a) {
      for (std::uint32_t b = a + 1; b < bodies.size(); ++b) {
        const Part &p = bodies[a].parts[0], &q = bodies[b].parts[0];
        const solid::RoundClearance clearance = solid::round_clearance(p.shape, p.pose, q.shape, q.pose, least);
        const Interval distance = distance_of(solid::round_distance(p.shape, p.pose, q.shape, q.pose));
        if (is_broken(clearance)) expected.emplace_back(a, b, 0, 0);
        exactly += is_kept(clearance) && distance.low == least && distance.high == least;
        low = std::min(low, distance.low);
        ties += nearest && distance.low == nearest->second.low && distance.high == nearest->second.high;
        if (!nearest || distance.high < nearest->second.high) nearest.emplace(Key{a, b, 0, 0}, distance);
      }
    }
    const ClearanceAnswer answer = closer_pairs(bodies, {least, {}, {}});
    std::vector<Key> found;
    for (const PartDistance& p : answer.closer) {
      EXPECT_LT(p.distance.low, least);
      EXPECT_EQ(p.meet(), p.distance.high == 0);
      EXPECT_EQ(rounded_nearest(p.evidence).has_value(), !p.meet());
      found.push_back(distance_key(p));
    }
    ASSERT_EQ(found, expected) << seed << " " << round;
    ASSERT_EQ(answer.pairs, answer.allowed + answer.by_boxes + answer.by_method);
    closer += static_cast<int>(found.size());
    by_boxes += static_cast<int>(answer.by_boxes);
    const std::optional<PartDistance> of_scene = nearest_parts(bodies);
    ASSERT_TRUE(of_scene && nearest);
    EXPECT_EQ(distance_key(*of_scene), nearest->first) << seed << " " << round;
    EXPECT_EQ(of_scene->distance.high, nearest->second.high);
    EXPECT_EQ(of_scene->distance.low, low);
  }
  EXPECT_GT(closer, rounds / 2);
  EXPECT_GT(by_boxes, rounds);
  if (!curved) {
    EXPECT_GT(exactly, rounds / 10);
    EXPECT_GT(ties, rounds / 10);
  }
}

TEST(Clearance, IsAllPairsOfHullsWithARadiusOnALattice) { compare_with_all_round_pairs(false, 83); }
TEST(Clearance, IsAllPairsOfCurvedBodies) { compare_with_all_round_pairs(true, 84); }

// Distances of hulls that differ by less than a double tells, or not at all: sqrt(n) - r against sqrt(m) - s.
TEST(Clearance, ComparesDistancesOfHullsExactly) {
  const auto scene = [](double far, double radius, double other_far, double other_radius) {
    return std::vector<Body>{
        {"a", {{"", solid::RoundBody::ball({0, 0, 0}, 0.5), Pose()}}},
        {"b", {{"", solid::RoundBody::ball({0, 0, 0}, radius), tests::shift(far, far, 0)}}},
        {"c", {{"", solid::RoundBody::ball({0, 0, 0}, other_radius), tests::shift(-other_far, 0, other_far)}}}};
  };
  const auto nearest = [](const std::vector<Body>& bodies) { return nearest_parts(bodies, {{1, 2}})->body_b; };
  const double bit = 0x1p-52;
  EXPECT_EQ(nearest(scene(3, 1, 3, 1)), 1u);  // as far: the first
  EXPECT_EQ(nearest(scene(3, 1, 3, 1 + bit)), 2u);
  EXPECT_EQ(nearest(scene(3, 1 + bit, 3, 1)), 1u);
  EXPECT_EQ(nearest(scene(3, 1, 3 - 2 * bit, 1)), 2u);
  // sqrt(2) far less radii: of 3 + 1 bits 2^-51 nearer, of a radius that is 2^-51 less further by less than that.
  EXPECT_EQ(nearest(scene(3, 1, 3 - 2 * bit, 1 - 2 * bit)), 2u);
  EXPECT_EQ(nearest(scene(3, 1, 3 - 2 * bit, 1 - 3 * bit)), 1u);
  EXPECT_EQ(nearest(scene(3 - 2 * bit, 1 - 2 * bit, 3, 1)), 1u);
  EXPECT_EQ(nearest(scene(3 - 2 * bit, 1 - 3 * bit, 3, 1)), 2u);
}

// Two points that are hardly apart, and a ball on the rim of a cylinder, in a point that no doubles hold, so that it is
// not known whether they meet: the points are nearest, as far as bounds tell, but the lower bound that is told is that
// of all.
TEST(Clearance, TheLowerBoundIsThatOfAll) {
  // The way from the axis to the ball's centre is 5^12 2^-28, three eighths more than the radius.
  const double x = 32125393 * 0x1p-28, y = 242017776 * 0x1p-28, radius = 244140625 * 0x1p-28 - 0.375;
  const solid::RoundBody cylinder = solid::RoundBody::cylinder({0, 0, -0.5}, {0, 0, 0.5}, radius);
  const solid::RoundBody ball = solid::RoundBody::ball({0, 0, 0}, 0.625), point = solid::RoundBody::ball({0, 0, 0}, 0);
  const double apart = 0x1p-200;
  int undecided = 0;
  for (const auto& [a, b] : {std::array{x, y}, {-x, y}, {x, -y}, {-x, -y}, {y, x}, {-y, x}, {y, -x}, {-y, -x}}) {
    for (const double z : {-1.0, 1.0}) {
      const Pose at = tests::shift(a, b, z);
      if (!round_round(cylinder, Pose(), ball, at).undecided()) continue;
      ++undecided;
      const std::vector<Body> bodies{{"a", {{"", cylinder, Pose()}}},
                                     {"b", {{"", ball, at}}},
                                     {"c", {{"", point, tests::shift(0, 9, 0)}}},
                                     {"d", {{"", point, tests::shift(apart, 9, 0)}}}};
      const PartDistance nearest = *nearest_parts(bodies);
      EXPECT_EQ(distance_key(nearest), (Key{2, 3, 0, 0}));
      EXPECT_EQ(nearest.distance.high, apart);
      EXPECT_EQ(nearest.distance.low, 0);
    }
  }
  EXPECT_GT(undecided, 8);
}

// Bodies in all directions, of all sizes, some endless along the axis that is sorted: none is passed over.
TEST(Clearance, NearestOfManyIsNearestOfAll) {
  Random random(tests::chosen_seed(86));
  for (int round = 0; round < tests::scaled_count(8, 2); ++round) {
    std::vector<Body> bodies;
    const double wide = round % 2 == 0 ? 40 : 8;
    for (int i = 0; i < 60; ++i) {
      const double long_one = random.below(10) == 0 ? 10 : 0.25;
      const solid::RoundBody shape = solid::RoundBody::capsule({0, 0, 0}, {long_one, 0.5, 0}, 0.25);
      bodies.push_back(
          {"",
           {{"", shape,
             tests::shift(random.uniform(-wide, wide), random.uniform(-wide, wide), random.uniform(-wide, wide))}}});
    }
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < bodies.size(); ++j) {
        const Part &a = bodies[i].parts[0], &b = bodies[j].parts[0];
        least = std::min(least, distance_of(solid::round_distance(a.shape, a.pose, b.shape, b.pose)).low);
      }
    }
    EXPECT_EQ(nearest_parts(bodies)->distance.low, least) << round;
  }
}

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
  EXPECT_EQ(distance_key(*nearest_parts(bodies)), (Key{0, 1, 0, 0}));
  EXPECT_FALSE(nearest_parts(std::span(bodies).first(1)));
}

}  // namespace
}  // namespace sunder::scene
