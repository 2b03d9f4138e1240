#include <sunder/base/random.h>
#include <sunder/scene/certified_test.h>
#include <sunder/scene/scene.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace sunder::scene {
namespace {

using tests::shift;

using solid::ConvexPolyhedron;
using solid::Pose;

// On a lattice: cubes that touch often. Else: anything, turned anyhow.
std::vector<Body> random_bodies(Random& random, bool lattice) {
  std::vector<Body> bodies(2 + random.below(12));
  const ConvexPolyhedron unit = ConvexPolyhedron(tests::cube_corners(0, 1));
  for (Body& body : bodies) {
    const std::uint64_t parts = random.below(4);
    for (std::uint64_t i = 0; i < parts; ++i) {
      const auto u = [&] { return random.uniform(-1, 1); };
      const auto n = [&] { return static_cast<double>(random.between(-2, 2)); };
      body.parts.push_back(lattice ? Part{"", unit, shift(n(), n(), n())}
                                   : Part{"", ConvexPolyhedron(tests::points_in_cube(1 + random.below(20), random)),
                                          Pose::from_quaternion(u(), u(), u(), 1, {3 * u(), 3 * u(), 3 * u()})});
    }
  }
  return bodies;
}

using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;
Key key(const PartPair& p) { return {p.body_a, p.body_b, p.part_a, p.part_b}; }

// Every two parts of different bodies, without boxes.
std::vector<Key> meeting_by_all_pairs(const std::vector<Body>& bodies, const Question& question, std::uint64_t& pairs) {
  std::vector<Key> meeting;
  for (std::uint32_t a = 0; a < bodies.size(); ++a) {
    for (std::uint32_t b = a + 1; b < bodies.size(); ++b) {
      bool allowed = false;
      for (const auto& [x, y] : question.allowed) allowed = allowed || (x == a && y == b) || (x == b && y == a);
      for (std::uint32_t i = 0; i < bodies[a].parts.size(); ++i) {
        for (std::uint32_t j = 0; j < bodies[b].parts.size(); ++j) {
          const Part &p = bodies[a].parts[i], &q = bodies[b].parts[j];
          ++pairs;
          if (!allowed && intersect(p.shape.core(), p.pose, q.shape.core(), q.pose).meet())
            meeting.emplace_back(a, b, i, j);
        }
      }
    }
  }
  return meeting;
}

void compare_with_all_pairs(bool lattice, int rounds, std::uint64_t seed) {
  Random random(seed);
  std::uint64_t meeting = 0, by_boxes = 0, by_method_apart = 0, allowed = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Body> bodies = random_bodies(random, lattice);
    Question question;
    for (std::uint64_t i = random.below(4); i > 0; --i) {
      question.allowed.push_back({static_cast<std::uint32_t>(random.below(bodies.size())),
                                  static_cast<std::uint32_t>(random.below(bodies.size()))});
    }
    std::uint64_t pairs = 0;
    const std::vector<Key> expected = meeting_by_all_pairs(bodies, question, pairs);
    for (const bool every_pair : {false, true}) {
      question.every_pair = every_pair;
      const Answer answer = meeting_pairs(bodies, question);
      std::vector<Key> found;
      for (const PartPair& pair : answer.pairs) {
        ASSERT_EQ(pair.counts, pair.answer.meet());
        ASSERT_FALSE(pair.by_boxes && pair.answer.meet());
        if (pair.answer.meet()) found.push_back(key(pair));
        expect_certified(bodies, pair);
        by_method_apart += !pair.by_boxes && !pair.answer.meet();
      }
      ASSERT_EQ(found, expected);
      ASSERT_TRUE(std::is_sorted(answer.pairs.begin(), answer.pairs.end(),
                                 [](const PartPair& p, const PartPair& q) { return key(p) < key(q); }));
      const Counts& c = answer.counts;
      ASSERT_EQ(c.pairs, pairs);
      ASSERT_EQ(c.pairs, c.allowed + c.by_boxes + c.by_method);
      ASSERT_EQ(c.meeting, expected.size());
      ASSERT_EQ(answer.pairs.size(), every_pair ? c.pairs - c.allowed : c.by_method);
      ASSERT_EQ(answer.some_meet(), !expected.empty());
      by_boxes += c.by_boxes;
      allowed += c.allowed;
    }
    meeting += expected.size();
  }
  const auto at_least = static_cast<std::uint64_t>(rounds);
  EXPECT_GT(meeting, at_least);
  EXPECT_GT(by_boxes, at_least);
  EXPECT_GT(allowed, at_least / 4);
  if (!lattice) {
    EXPECT_GT(by_method_apart, at_least);
  }
}

TEST(Scene, IsAllPairsInGeneralPosition) { compare_with_all_pairs(false, 200, 4); }
TEST(Scene, IsAllPairsOnALattice) { compare_with_all_pairs(true, 200, 5); }

TEST(Scene, BoxesNeverHideWhatOnlyTouches) {
  std::vector<Body> bodies{{"middle", {{"", ConvexPolyhedron(tests::cube_corners(0, 1)), Pose()}}}};
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0)
          bodies.push_back({"", {{"", ConvexPolyhedron(tests::cube_corners(0, 1)), shift(x, y, z)}}});
      }
    }
  }
  Question question;
  question.contacts = true;
  const Answer answer = meeting_pairs(bodies, question);
  const auto with_middle = std::count_if(answer.pairs.begin(), answer.pairs.end(), [](const PartPair& pair) {
    return pair.body_a == 0 && pair.counts && pair.relation == Relation::touching;
  });
  EXPECT_EQ(with_middle, 26);
}

TEST(Scene, TouchingMayBeAllowed) {
  const std::vector<Body> bodies{{"a", {{"", ConvexPolyhedron(tests::cube_corners(0, 1)), Pose()}}},
                                 {"b", {{"", ConvexPolyhedron(tests::cube_corners(0, 1)), shift(1, 0, 0)}}},
                                 {"c", {{"", ConvexPolyhedron(tests::cube_corners(0, 1)), shift(1.5, 0, 0)}}}};
  Question question;
  const Answer strict = meeting_pairs(bodies, question);
  question.touching_allowed = true;
  const Answer lenient = meeting_pairs(bodies, question);
  EXPECT_EQ(strict.counts.meeting, 2u);
  EXPECT_EQ(strict.counts.touching_only, 0u);
  EXPECT_EQ(lenient.counts.meeting, 2u);
  EXPECT_EQ(lenient.counts.touching_only, 1u);
  EXPECT_TRUE(lenient.some_meet());
  ASSERT_EQ(lenient.pairs.size(), 2u);
  EXPECT_FALSE(lenient.pairs[0].counts);
  EXPECT_TRUE(lenient.pairs[1].counts);
  EXPECT_FALSE(meeting_pairs(std::span(bodies).first(2), question).some_meet());
}

TEST(Scene, FarPairsCostNothing) {
  std::vector<Body> bodies;
  for (int i = 0; i < 2000; ++i)
    bodies.push_back({"", {{"", ConvexPolyhedron(tests::cube_corners(0, 1)), shift(0, 0, 3 * i)}}});
  const Answer answer = meeting_pairs(bodies);
  EXPECT_TRUE(answer.pairs.empty());
  EXPECT_EQ(answer.counts.by_method, 0u);
  EXPECT_EQ(answer.counts.by_boxes, 2000u * 1999 / 2);
}

TEST(Scene, NothingAndNoParts) {
  EXPECT_FALSE(meeting_pairs({}).some_meet());
  const std::vector<Body> bodies(3);
  EXPECT_EQ(meeting_pairs(bodies).counts.pairs, 0u);
}

}  // namespace
}  // namespace sunder::scene
