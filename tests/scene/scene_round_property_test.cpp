// Scenes of bodies with a radius and polyhedra: against all pairs by round_round, placement after placement, and with
// certificates that the verifier accepts.
#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <sunder/scene/follower.h>
#include <sunder/scene/scene_claims.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/round/world_box.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace sunder::tests {
namespace {

using scene::Answer;
using scene::Body;
using scene::Follower;
using scene::Part;
using scene::PartPair;
using scene::Question;
using solid::PlacedRound;
using solid::Pose;
using solid::RoundBody;

Pose anywhere(double size, Random& random) {
  const auto u = [&] { return random.uniform(-1, 1); };
  return Pose::from_quaternion(u(), u(), u(), u() + 0.1, {size * u(), size * u(), size * u()});
}

// Bodies of up to two parts, of all primitives in turn.
std::vector<Body> some_bodies(std::size_t count, double size, Random& random) {
  std::vector<Body> bodies(count);
  int turn = static_cast<int>(random.below(primitive_count));
  for (Body& body : bodies) {
    for (std::uint64_t i = random.below(3); i > 0; --i) {
      const auto primitive = static_cast<Primitive>(turn++ % primitive_count);
      body.parts.push_back({"", some_primitive(primitive, random), anywhere(size, random)});
    }
  }
  return bodies;
}

using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, Verdict>;

// The pairs that are not apart, without boxes.
std::vector<Key> by_all_pairs(const std::vector<Body>& bodies) {
  std::vector<Key> keys;
  for (std::uint32_t a = 0; a < bodies.size(); ++a) {
    for (std::uint32_t b = a + 1; b < bodies.size(); ++b) {
      for (std::uint32_t i = 0; i < bodies[a].parts.size(); ++i) {
        for (std::uint32_t j = 0; j < bodies[b].parts.size(); ++j) {
          const Part &p = bodies[a].parts[i], &q = bodies[b].parts[j];
          const Verdict verdict = round_round(p.shape, p.pose, q.shape, q.pose).verdict();
          if (verdict != Verdict::apart) keys.emplace_back(a, b, i, j, verdict);
        }
      }
    }
  }
  return keys;
}

std::vector<Key> listed(const Answer& answer) {
  std::vector<Key> keys;
  for (const PartPair& p : answer.pairs) {
    if (!p.meet() && !p.undecided()) continue;
    keys.emplace_back(p.body_a, p.body_b, p.part_a, p.part_b, p.meet() ? Verdict::meet : Verdict::undecided);
  }
  return keys;
}

std::string certificate_of(std::span<const Body> bodies, const Answer& answer, const Question& question) {
  std::string text;
  const std::vector<scene::Placement> placements{{"", bodies, answer}};
  write_certificate(placements, question, {}, [&](std::string_view piece) { text += piece; });
  return text;
}

// W1, exactly; and the box is tight.
TEST(SceneRound, BoxesHoldTheBodyAndNoMuchMore) {
  const std::uint64_t seed = chosen_seed(20261201);
  RoundPairs pairs(seed);
  const Affine3 identity{};
  int tight = 0, all = 0;
  for (int i = 0; i < scaled_count(2000, 200); ++i) {
    const RoundCase c = pairs.next();
    const PlacedRound body(c.a, c.pose_a);
    const solid::WorldBox box = solid::world_box(body);
    const Box3 rough = solid::rough_world_box(body);
    for (std::size_t k = 0; k < 3; ++k) {
      for (const bool up : {false, true}) {
        const double bound = up ? box.high[k] : box.low[k];
        ASSERT_TRUE(up ? rough.high[k] >= box.high[k] || c.a.is_curved()
                       : rough.low[k] <= box.low[k] || c.a.is_curved());
        Point3 d{0, 0, 0};
        d[k] = up ? 1 : -1;
        RoundShape shape = body.shape;
        if (body.kind() == RoundKind::hull) {
          shape.points[0] = c.a.points()[up ? box.highest[k] : box.lowest[k]];
        }
        const auto beyond = [&](double at) {  // is some of the body beyond this?
          RoundShape plane{RoundKind::hull, {}, &identity, 0};
          plane.points[0][k] = at;
          return gap_sign(WorldDirection(d), shape, plane) == Sign::negative;
        };
        for (const double at : {bound, up ? rough.high[k] : rough.low[k]}) {
          if (std::isfinite(at)) {
            ASSERT_FALSE(beyond(at)) << seed << " " << i << " " << k << " " << up;
          }
        }
        const double size = body.core.size + body.radius() * (body.kind() == RoundKind::ellipsoid ? 4 : 1);
        // (Where the radius is far above the axis, or the squares of the axis leave the doubles, it is the radius.)
        if (!(size > 1e-140 && size < 1e140) || c.family == RoundFamily::degenerate) continue;
        ++all;
        tight += beyond(bound + (up ? -1 : 1) * 0x1p-40 * size);
      }
    }
  }
  EXPECT_GT(all, 3 * scaled_count(2000, 200));
  EXPECT_EQ(tight, all);
}

TEST(SceneRound, IsAllPairs) {
  const std::uint64_t seed = chosen_seed(20261202);
  Random random(seed);
  const int rounds = scaled_count(60, 6);
  std::uint64_t meeting = 0, apart = 0, by_boxes = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Body> bodies = some_bodies(12, 3, random);
    const std::vector<Key> expected = by_all_pairs(bodies);
    Question question;
    question.contacts = round % 2 == 0;
    for (const bool every_pair : {false, true}) {
      question.every_pair = every_pair;
      const Answer answer = meeting_pairs(bodies, question);
      ASSERT_EQ(listed(answer), expected) << seed << " " << round;
      ASSERT_EQ(answer.counts.meeting + answer.counts.undecided, expected.size());
      ASSERT_EQ(answer.counts.pairs, answer.counts.by_boxes + answer.counts.by_method);
      ASSERT_EQ(answer.pairs.size(), every_pair ? answer.counts.pairs : answer.counts.by_method);
      if (!every_pair || answer.pairs.empty()) continue;
      by_boxes += answer.counts.by_boxes;
      apart += answer.counts.by_method - answer.counts.meeting;
      const auto result = sunder_verifier::verify_text(certificate_of(bodies, answer, question), "certificate",
                                                       sunder_verifier::Limit::none);
      ASSERT_TRUE(result.accepted()) << seed << " " << round << result.failed_form << result.error;
      ASSERT_EQ(result.statements.size(), answer.pairs.size() - answer.counts.undecided + 1);
    }
    meeting += expected.size();
  }
  EXPECT_GT(meeting, static_cast<std::uint64_t>(rounds));
  EXPECT_GT(apart, static_cast<std::uint64_t>(rounds));
  EXPECT_GT(by_boxes, static_cast<std::uint64_t>(rounds));
}

TEST(SceneRound, FollowerLosesNoPair) {
  const std::uint64_t seed = chosen_seed(20261203);
  Random random(seed);
  const int rounds = scaled_count(20, 3);
  std::uint64_t meeting = 0;
  for (int round = 0; round < rounds; ++round) {
    // Few bodies, whose pairs are all looked at, and many, where what is near is followed.
    std::vector<Body> bodies = some_bodies(round % 2 == 0 ? 10 : 60, round % 2 == 0 ? 2 : 6, random);
    Follower follower(bodies);
    for (int step = 0; step < 8; ++step) {
      const Answer& answer = follower.ask();
      ASSERT_EQ(listed(answer), listed(meeting_pairs(bodies))) << seed << " " << round << " " << step;
      ASSERT_EQ(answer.pairs.size(), answer.counts.meeting + answer.counts.undecided);
      meeting += answer.counts.meeting;
      std::uint32_t number = 0;
      for (Body& body : bodies) {
        for (Part& part : body.parts) {
          const std::uint32_t here = number++;
          if (random.below(3) == 0) continue;
          const auto u = [&] { return 0.05 * random.uniform(-1, 1); };
          part.pose = random.below(10) == 0 ? anywhere(3, random) : compose(shift(u(), u(), u()), part.pose);
          follower.place(here, part.pose);
        }
      }
    }
  }
  EXPECT_GT(meeting, static_cast<std::uint64_t>(rounds) * 8);
}

// Balls that come nearer by a last bit at a time, over the moment where they touch.
TEST(SceneRound, TellsTheLastBit) {
  const RoundBody ball = RoundBody::ball({0, 0, 0}, 0.5);
  const std::vector<Body> bodies{{"a", {{"", ball, Pose()}}}, {"b", {{"", ball, shift(1.5, 0, 0)}}}};
  Follower follower(bodies);
  EXPECT_TRUE(follower.ask().none_meet());
  for (int bit = 8; bit >= -8; --bit) {
    follower.place(1, shift(1 + bit * 0x1p-52, 0, 0));
    EXPECT_EQ(follower.ask().some_meet(), bit <= 0) << bit;
  }
  Question question;
  question.touching_allowed = true;
  std::vector<Body> touching = bodies;
  touching[1].parts[0].pose = shift(1, 0, 0);
  const Answer allowed = meeting_pairs(touching, question);
  EXPECT_EQ(allowed.counts.touching_only, 1u);
  EXPECT_TRUE(allowed.none_meet());
}

// Two that nearly touch, so that it is undecided whether they meet.
std::vector<Body> undecided_bodies() {
  RoundPairs pairs(20261204);
  for (int i = 0; i < 3000; ++i) {
    const RoundCase c = pairs.next(i % 2 == 0 ? RoundFamily::near_contact : RoundFamily::last_bit, Primitive::cylinder,
                                   Primitive::cylinder);
    if (!round_round(c.a, c.pose_a, c.b, c.pose_b).undecided()) continue;
    return {{"a", {{"", c.a, c.pose_a}}}, {"b", {{"", c.b, c.pose_b}}}};
  }
  return {};
}

TEST(SceneRound, WhatIsUndecidedIsSaid) {
  std::vector<Body> bodies = undecided_bodies();
  ASSERT_EQ(bodies.size(), 2u);
  bodies.push_back({"far", {{"", RoundBody::ball({100, 0, 0}, 1), Pose()}}});
  Question question;
  question.every_pair = true;
  const Answer answer = meeting_pairs(bodies, question);
  EXPECT_EQ(answer.verdict(), "undecided");
  EXPECT_FALSE(answer.some_meet());
  EXPECT_FALSE(answer.none_meet());
  EXPECT_EQ(answer.counts.undecided, 1u);
  ASSERT_EQ(answer.pairs.size(), 3u);
  EXPECT_EQ(answer.pairs[0].verdict(), Verdict::undecided);
  EXPECT_FALSE(answer.pairs[0].counts);
  Follower follower(bodies);
  ASSERT_EQ(follower.ask().pairs.size(), 1u);
  EXPECT_EQ(follower.ask().verdict(), "undecided");
  // The file states what is proved, and tells of the rest.
  const auto result = sunder_verifier::verify_text(certificate_of(bodies, answer, question), "certificate");
  EXPECT_TRUE(result.accepted());
  EXPECT_EQ(result.left_out, (std::vector<std::string>{"a and b, undecided whether they meet"}));
  EXPECT_EQ(result.statements.size(), 3u);
}

// A radius stays as it is: no scale, no shear.
TEST(SceneRound, RefusesAPoseThatScales) {
  const std::vector<Body> bodies{{"a", {{"", RoundBody::ball({0, 0, 0}, 1), Pose()}}}, {"b", {}}};
  const Pose twice = Pose::from_matrix({2, 0, 0, 0, 2, 0, 0, 0, 2}, {0, 0, 0});
  Follower follower(bodies);
  EXPECT_THROW(follower.place(0, twice), Error);
  std::vector<Body> scaled = bodies;
  scaled[0].parts[0].pose = twice;
  EXPECT_THROW(static_cast<void>(meeting_pairs(scaled)), Error);
}

}  // namespace
}  // namespace sunder::tests
