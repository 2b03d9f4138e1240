#include <sunder/base/random.h>
#include <sunder/scene/certified_test.h>
#include <sunder/scene/follower.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace sunder::scene {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;

using MeetingKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, bool, Relation>;

std::vector<MeetingKey> meeting(const Answer& answer) {
  std::vector<MeetingKey> keys;
  for (const PartPair& p : answer.pairs) {
    if (p.answer.meet()) keys.emplace_back(p.body_a, p.body_b, p.part_a, p.part_b, p.counts, p.relation);
  }
  return keys;
}

// Bodies of up to three parts: cubes on a lattice, that touch often; or anything.
class Bodies {
 public:
  Bodies(std::size_t count, bool lattice, Random& random) : lattice_(lattice), random_(random) {
    const ConvexPolyhedron cube(tests::cube_corners(0, 1));
    bodies.resize(count);
    for (Body& body : bodies) {
      for (std::uint64_t i = random.below(4); i > 0; --i) {
        body.parts.push_back(
            {"", lattice ? cube : ConvexPolyhedron(tests::points_in_cube(1 + random.below(20), random)), anywhere()});
      }
    }
  }

  // Of a part at `pose`: anywhere, or a little further.
  Pose next(const Pose& pose) {
    if (random_.below(10) == 0) return anywhere();
    if (lattice_) {
      const auto n = [&] { return static_cast<double>(random_.between(-1, 1)) / 8; };
      return compose(tests::shift(n(), n(), n()), pose);
    }
    const auto u = [&] { return 0.02 * random_.uniform(-1, 1); };
    return compose(Pose::from_quaternion(1, u(), u(), u(), {u(), u(), u()}), pose);
  }

  std::vector<Body> bodies;

 private:
  Pose anywhere() {
    const auto u = [&] { return random_.uniform(-1, 1); };
    const auto n = [&] { return static_cast<double>(random_.between(-2, 2)); };
    return lattice_ ? tests::shift(n(), n(), n())
                    : Pose::from_quaternion(u(), u(), u(), 1, {3 * u(), 3 * u(), 3 * u()});
  }

  bool lattice_;
  Random& random_;
};

void compare_with_meeting_pairs(bool lattice, std::uint64_t seed) {
  Random random(tests::chosen_seed(seed));
  std::uint64_t pairs = 0, allowed = 0, touching = 0, warm = 0;
  const int rounds = tests::scaled_count(100, 10);
  for (int round = 0; round < rounds; ++round) {
    // Few bodies, whose pairs are listed; or so many that those near each other are followed.
    const bool is_many = round % 10 == 9;
    Bodies moving(is_many ? 40 + random.below(30) : 2 + random.below(12), lattice, random);
    Question question;
    for (std::uint64_t i = random.below(4); i > 0; --i) {
      question.allowed.push_back({static_cast<std::uint32_t>(random.below(moving.bodies.size())),
                                  static_cast<std::uint32_t>(random.below(moving.bodies.size()))});
    }
    question.touching_allowed = lattice && !is_many && random.below(2) == 0;
    question.contacts = !is_many && random.below(2) == 0;
    Follower follower(moving.bodies, question);
    for (int step = 0; step < (is_many ? 10 : 30); ++step) {
      const Answer& answer = follower.ask();
      const Answer expected = meeting_pairs(moving.bodies, question);
      ASSERT_EQ(meeting(answer), meeting(expected)) << seed << " " << round << " " << step;
      ASSERT_EQ(answer.pairs.size(), meeting(answer).size());
      const Counts &c = answer.counts, &e = expected.counts;
      ASSERT_EQ(std::tie(c.parts, c.pairs, c.allowed, c.meeting, c.touching_only),
                std::tie(e.parts, e.pairs, e.allowed, e.meeting, e.touching_only));
      ASSERT_EQ(c.pairs, c.allowed + c.by_boxes + c.by_method);
      ASSERT_EQ(answer.some_meet(), expected.some_meet());
      for (const PartPair& pair : answer.pairs) {
        ASSERT_NO_FATAL_FAILURE(expect_certified(moving.bodies, pair));
        warm += pair.answer.cost.iterations == 0;
      }
      pairs += c.meeting;
      allowed += c.allowed;
      touching += c.touching_only;
      std::uint32_t number = 0;
      for (Body& body : moving.bodies) {
        for (Part& part : body.parts) {
          const std::uint32_t here = number++;
          if (random.below(3) == 0) continue;
          part.pose = moving.next(part.pose);
          follower.place(here, part.pose);
        }
      }
    }
  }
  EXPECT_GT(pairs, static_cast<std::uint64_t>(rounds) * 30);
  EXPECT_GT(allowed, static_cast<std::uint64_t>(rounds));
  EXPECT_GT(warm, pairs / (lattice ? 6 : 3));
  if (lattice) {
    EXPECT_GT(touching, static_cast<std::uint64_t>(rounds));
  }
}

TEST(Follower, IsMeetingPairsInGeneralPosition) { compare_with_meeting_pairs(false, 71); }
TEST(Follower, IsMeetingPairsOnALattice) { compare_with_meeting_pairs(true, 72); }

// F1, of what is undecided: a cone hundreds of orders of magnitude smaller than the cube over it. Boxes that are exact
// to some roundings of their ends part them, and rough ones do not.
TEST(Follower, LeavesNothingUndecidedThatBoxesTell) {
  const double tiny = 0x1p-1000, huge = 0x1p128;
  std::vector<Point3> corners = tests::cube_corners(0, 1);
  for (Point3& p : corners) p = {huge * p.x, huge * p.y, huge * p.z};
  const ConvexPolyhedron cube(corners);
  const auto cone = solid::RoundBody::cone({1.5 * tiny, -2 * tiny, -6 * tiny}, {tiny, -3 * tiny, 5 * tiny}, 5 * tiny);
  const std::vector<Body> bodies{{"", {{"", cone, Pose()}}},
                                 {"", {{"", cube, tests::shift(-0x1p-499, -0x1p-498, 0x1p-498)}}}};
  ASSERT_TRUE(round_round(cone, Pose(), cube, bodies[1].parts[0].pose).undecided());
  Follower follower(bodies);
  const Answer& answer = follower.ask();
  EXPECT_TRUE(meeting_pairs(bodies).none_meet());
  EXPECT_TRUE(answer.none_meet());
  EXPECT_TRUE(answer.pairs.empty());
  EXPECT_EQ(answer.counts.by_boxes, 1);
}

// F2: the evidence after forget() is that of a new follower, to the vertex.
TEST(Follower, ForgetsAllOfIt) {
  Random random(tests::chosen_seed(73));
  int met = 0, same_without = 0;
  for (int round = 0; round < 50; ++round) {
    Bodies moving(8, false, random);
    Follower old(moving.bodies), left_warm(moving.bodies);
    for (int step = 0; step < 10; ++step) {
      old.ask();
      left_warm.ask();
      std::uint32_t number = 0;
      for (Body& body : moving.bodies) {
        for (Part& part : body.parts) {
          part.pose = moving.next(part.pose);
          old.place(number, part.pose);
          left_warm.place(number++, part.pose);
        }
      }
    }
    old.forget();
    Follower anew(moving.bodies);
    const Answer &a = old.ask(), &b = anew.ask(), &c = left_warm.ask();
    ASSERT_EQ(a.pairs.size(), b.pairs.size());
    ASSERT_EQ(a.pairs.size(), c.pairs.size());
    ASSERT_EQ(a.counts.by_method, b.counts.by_method);
    for (std::size_t k = 0; k < a.pairs.size(); ++k) {
      const solid::RoundAnswer &x = a.pairs[k].answer, &y = b.pairs[k].answer, &z = c.pairs[k].answer;
      ASSERT_EQ(std::get<CommonVertices>(x.evidence).vertices, std::get<CommonVertices>(y.evidence).vertices);
      ASSERT_EQ(x.cost.probes, y.cost.probes);
      ++met;
      same_without += x.cost.probes == z.cost.probes;
    }
  }
  EXPECT_GT(met, 50);
  EXPECT_LT(same_without, met / 2);
}

TEST(Follower, NothingAndNoParts) {
  EXPECT_FALSE(Follower({}).ask().some_meet());
  EXPECT_EQ(Follower(std::vector<Body>(3)).ask().counts.pairs, 0u);
}

// Sums of coordinates that overflow, though all images are small.
TEST(Follower, CoordinatesAtTheEndOfTheRangeOfDoubles) {
  constexpr double most = std::numeric_limits<double>::max(), small = 0x1p-800;
  const Pose pose = Pose::from_matrix({small, 0, 0, 0, small, 0, 0, 0, small}, {0, 0, 0});
  for (const std::vector<Point3>& points :
       {std::vector<Point3>{{most, 0, 0}, {-most, 0, 0}},
        std::vector<Point3>{{most, 0, 0}, {most / 1.5, most, 0}, {most, 0, most}}}) {
    const ConvexPolyhedron shape(points);
    EXPECT_TRUE(Follower(std::vector<Body>{{"a", {{"", shape, pose}}}, {"b", {{"", shape, pose}}}}).ask().some_meet());
  }
}

// Two cubes that come nearer by a last bit at a time, over the moment where they touch.
TEST(Follower, TellsTheLastBit) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  const std::vector<Body> bodies{{"a", {{"", cube, Pose()}}}, {"b", {{"", cube, tests::shift(1.5, 0, 0)}}}};
  Follower follower(bodies);
  EXPECT_FALSE(follower.ask().some_meet());
  for (int bit = 8; bit >= -8; --bit) {
    follower.place(1, tests::shift(1 + bit * 0x1p-52, 0, 0));
    EXPECT_EQ(follower.ask().some_meet(), bit <= 0) << bit;
  }
}

}  // namespace
}  // namespace sunder::scene
