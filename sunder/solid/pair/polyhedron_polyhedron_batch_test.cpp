#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_batch.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <list>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

struct Asked {
  std::list<ConvexPolyhedron> bodies;  // which stay where they are
  std::list<Pose> poses;
  std::vector<PlacedPair> pairs;
  std::vector<std::string> names;

  void add(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
           const std::string& name) {
    poses.push_back(pose_a);
    const Pose* const at_a = &poses.back();
    poses.push_back(pose_b);
    pairs.push_back({&a, at_a, &b, &poses.back()});
    names.push_back(name);
  }
};

// All families, some pairs by themselves, and some in runs of placements around the first: near, the same, far.
Asked all_families(int pairs, std::uint64_t seed) {
  Asked asked;
  tests::SolidPairs all(tests::chosen_seed(seed));
  Random& random = all.random();
  for (int k = 0; k < pairs; ++k) {
    const tests::PairCase c = all.next();
    const ConvexPolyhedron& a = asked.bodies.emplace_back(c.a);
    const ConvexPolyhedron& b = asked.bodies.emplace_back(c.b);
    const std::string name = std::to_string(k) + " " + std::string(tests::name_of(c.family));
    asked.add(a, c.pose_a, b, c.pose_b, name);
    if (k % 3 == 0) continue;
    const bool is_extreme = c.family == tests::Family::tiny_or_huge || tests::is_stretched(c.family);
    for (std::uint64_t more = random.below(20); more > 0; --more) {
      if (is_extreme || random.below(4) == 0) {
        asked.add(a, c.pose_a, b, c.pose_b, name + " again");
        continue;
      }
      const double by = random.log_uniform(1e-15, 3);
      const auto u = [&] { return by * random.uniform(-1, 1); };
      const Pose turn = Pose::from_quaternion(1, u(), u(), u(), {u(), u(), u()});
      const bool moves_a = random.below(2) == 0;
      asked.add(a, moves_a ? compose(turn, c.pose_a) : c.pose_a, b, moves_a ? c.pose_b : compose(turn, c.pose_b),
                name + " moved");
    }
  }
  return asked;
}

TEST(PolyhedronPolyhedronBatch, HasTheVerdictsOfSinglePairs) {
  const int rounds = tests::scaled_count(600, 60);
  const Asked asked = all_families(rounds, 81);
  std::vector<std::uint8_t> meet(asked.pairs.size(), 7), without(asked.pairs.size(), 7);
  std::vector<PairAnswer> answers(asked.pairs.size());
  polyhedron_polyhedron_batch(asked.pairs, meet, {1, answers});
  polyhedron_polyhedron_batch(asked.pairs, without);
  EXPECT_EQ(meet, without);
  std::size_t meeting = 0;
  for (std::size_t k = 0; k < asked.pairs.size(); ++k) {
    const auto& [a, pose_a, b, pose_b] = asked.pairs[k];
    ASSERT_EQ(meet[k], polyhedron_polyhedron(*a, *pose_a, *b, *pose_b).meet() ? 1 : 0) << asked.names[k];
    if (meet[k] == 0) continue;
    ++meeting;
    ASSERT_EQ(check_absolutely(answers[k].evidence, {a->vertices(), pose_a->affine(), false},
                               {b->vertices(), pose_b->affine(), false}),
              CheckResult::accepted)
        << asked.names[k];
  }
  EXPECT_GT(meeting, asked.pairs.size() / 5);
  EXPECT_LT(meeting, asked.pairs.size() * 4 / 5);
}

// B2, to the vertex.
TEST(PolyhedronPolyhedronBatch, IsTheSameForAnyNumberOfThreads) {
  const Asked asked = all_families(tests::scaled_count(200, 40), 82);
  const auto outcome = [&](std::size_t threads) {
    std::vector<std::uint8_t> meet(asked.pairs.size());
    std::vector<PairAnswer> answers(asked.pairs.size());
    polyhedron_polyhedron_batch(asked.pairs, meet, {threads, answers});
    std::vector<std::uint32_t> all(meet.begin(), meet.end());
    for (const PairAnswer& answer : answers) {
      const auto* common = std::get_if<CommonVertices>(&answer.evidence);
      if (common != nullptr) all.insert(all.end(), common->vertices.begin(), common->vertices.end());
    }
    return all;
  };
  const std::vector<std::uint32_t> one = outcome(1);
  for (const std::size_t threads : {std::size_t{0}, std::size_t{2}, std::size_t{5}}) EXPECT_EQ(outcome(threads), one);
}

// Cubes that come nearer by a last bit at a time, over the moment where they touch; placed as they are, and turned.
TEST(PolyhedronPolyhedronBatch, TellsTheLastBit) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  const Pose still;
  std::vector<Pose> poses;
  std::vector<std::uint8_t> expected;
  for (int bit = 40; bit >= -40; --bit) {
    poses.push_back(tests::shift(1 + bit * 0x1p-52, 0, 0));
    expected.push_back(bit <= 0);
  }
  std::vector<PlacedPair> pairs;
  for (const Pose& pose : poses) pairs.push_back({&cube, &still, &cube, &pose});
  std::vector<std::uint8_t> meet(pairs.size());
  polyhedron_polyhedron_batch(pairs, meet);
  EXPECT_EQ(meet, expected);
  for (PlacedPair& pair : pairs) std::swap(pair.pose_a, pair.pose_b);
  polyhedron_polyhedron_batch(pairs, meet);
  EXPECT_EQ(meet, expected);
}

// Rods end to end but for rounding, turned anyhow: what decides is far below what floating point tells, and the rods
// are so thin, and so far from where their frames begin, that it does not matter how the direction between their
// middles departs from theirs.
TEST(PolyhedronPolyhedronBatch, TellsEndsApartUnderAnyRotation) {
  std::vector<Point3> corners = tests::cube_corners(0, 1);
  for (Point3& p : corners) p = {1000 + p.x, 0x1p-20 * p.y, 0x1p-20 * p.z};
  const ConvexPolyhedron rod(corners);
  Random random(tests::chosen_seed(85));
  const auto u = [&] { return random.uniform(-1, 1); };
  Asked asked;
  for (int k = 0; k < 500; ++k) {
    const Pose turn = Pose::from_quaternion(u(), u(), u(), u(), {u(), u(), u()});
    asked.add(rod, turn, rod, compose(turn, tests::shift(1, 0, 0)), std::to_string(k));
  }
  std::vector<std::uint8_t> meet(asked.pairs.size());
  polyhedron_polyhedron_batch(asked.pairs, meet);
  int meeting = 0;
  for (std::size_t k = 0; k < asked.pairs.size(); ++k) {
    const auto& [a, pose_a, b, pose_b] = asked.pairs[k];
    ASSERT_EQ(meet[k], polyhedron_polyhedron(*a, *pose_a, *b, *pose_b).meet() ? 1 : 0) << k;
    meeting += meet[k];
  }
  EXPECT_GT(meeting, 50);
  EXPECT_LT(meeting, 450);
}

TEST(PolyhedronPolyhedronBatch, OfNone) { EXPECT_NO_THROW(polyhedron_polyhedron_batch({}, {}, {3, {}})); }

}  // namespace
}  // namespace sunder::solid
