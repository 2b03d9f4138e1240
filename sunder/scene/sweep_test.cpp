#include <sunder/scene/sweep.h>
#include <tests/support/mesh_soups.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace sunder::scene {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;
using solid::RoundBody;
using tests::shift;

Body body(const std::string& name, const RoundBody& shape, const Pose& at = {}) { return {name, {{name, shape, at}}}; }

const ConvexPolyhedron& cube() {
  static const ConvexPolyhedron made(tests::cube_corners(0, 1));
  return made;
}

// "0-1@0.25 0-2@1!": pairs of bodies, the time, and ! where only the ends were asked about.
std::string listed(const SweptAnswer& answer) {
  std::string text;
  for (const SweptPair& pair : answer.pairs) {
    EXPECT_EQ(pair.time().low, pair.time().high);
    std::string time = std::to_string(pair.time().low);
    time.erase(time.find_last_not_of('0') + 1);
    text += (text.empty() ? "" : " ") + std::to_string(pair.body_a) + "-" + std::to_string(pair.body_b) + "@" + time +
            (pair.all_the_way() ? "" : "!");
  }
  return text;
}

TEST(SceneSweep, SeesWhatIsBetween) {
  const std::vector<Body> begin{body("a", cube()), body("b", cube(), shift(-3, 0, 0)),
                                body("c", cube(), shift(9, 9, 9))};
  std::vector<Body> end = begin;
  end[1].parts[0].pose = shift(5, 0, 0);
  const SweptAnswer answer = meeting_on_the_way(begin, end);
  EXPECT_EQ(listed(answer), "0-1@0.25");
  EXPECT_FALSE(meeting_pairs(begin).some_meet());
  EXPECT_FALSE(meeting_pairs(end).some_meet());
  EXPECT_EQ(answer.counts.pairs, 3u);
  EXPECT_EQ(answer.counts.by_boxes, 2u);
  EXPECT_EQ(answer.counts.by_method, 1u);
  EXPECT_EQ(answer.counts.at_ends_only, 0u);
  EXPECT_TRUE(answer.some_meet());
  const SweptAnswer allowed = meeting_on_the_way(begin, end, {.allowed = {{1, 0}}});
  EXPECT_EQ(listed(allowed), "");
  EXPECT_TRUE(allowed.none_meet());
  EXPECT_EQ(allowed.counts.allowed, 1u);
  // All move alike: nothing changes.
  std::vector<Body> all = begin;
  for (Body& one : all) {
    auto t = one.parts[0].pose.affine().translation;
    one.parts[0].pose = shift(t[0] + 32, t[1] - 8, t[2]);
  }
  EXPECT_TRUE(meeting_on_the_way(begin, all).none_meet());
}

TEST(SceneSweep, SaysWhatTurns) {
  std::vector<Body> begin{body("a", cube()), body("b", cube(), shift(-3, 0, 0)),
                          body("ball", RoundBody::ball({}, 1), shift(-3, 8, 0))};
  std::vector<Body> end = begin;
  end[1].parts[0].pose = Pose::from_quaternion(1, 0, 0, 1, {-3, 0, 0});
  SweptAnswer answer = meeting_on_the_way(begin, end);
  EXPECT_EQ(listed(answer), "");
  EXPECT_EQ(answer.counts.at_ends_only, 2u);
  EXPECT_EQ(answer.verdict(), "undecided");
  EXPECT_FALSE(answer.none_meet());
  EXPECT_FALSE(answer.some_meet());
  end[1].parts[0].pose = Pose::from_quaternion(1, 0, 0, 1, {1, 0, 0});
  answer = meeting_on_the_way(begin, end);
  EXPECT_EQ(listed(answer), "0-1@1.!");
  EXPECT_TRUE(std::get<MeetAtAnEnd>(answer.pairs[0].evidence).pair->meet());
}

TEST(SceneSweep, TakesBodiesWithARadiusAllTheWay) {
  std::vector<Body> begin{body("a", cube()), body("ball", RoundBody::ball({}, 1), shift(-3, 8, 0)),
                          body("post", RoundBody::cylinder({0, 0, -4}, {0, 0, 4}, 0.25), shift(3, 8, 0))};
  std::vector<Body> end = begin;
  end[1].parts[0].pose = shift(3, -8, 0);
  Question question;
  question.every_pair = true;
  const SweptAnswer answer = meeting_on_the_way(begin, end, question);
  ASSERT_EQ(answer.pairs.size(), 3u);
  const SweptPair& through = answer.pairs[0];  // the ball goes through the cube
  EXPECT_TRUE(through.meet());
  EXPECT_GT(through.time().low, 0.3);
  EXPECT_LE(through.time().high - through.time().low, 0x1p-40);
  EXPECT_TRUE(std::holds_alternative<MeetOnTheWay>(through.evidence));
  for (const std::size_t k : {1u, 2u}) {
    EXPECT_EQ(answer.pairs[k].verdict(), Verdict::apart);
    EXPECT_TRUE(std::get<ApartOnTheWay>(answer.pairs[k].evidence).direction != nullptr);
  }
  EXPECT_EQ(answer.counts.meeting, 1u);
  EXPECT_EQ(answer.counts.by_boxes, 1u);  // cube and post; the ball begins beside the post
  EXPECT_EQ(answer.counts.at_ends_only, 0u);
  EXPECT_EQ(meeting_on_the_way(begin, end).pairs.size(), 1u);
}

// W1: against times that are looked at one by one.
TEST(SceneSweep, LosesNothingThatAnySampleFinds) {
  const int count = tests::scaled_count(60, 6);
  const std::uint64_t seed = tests::chosen_seed(20270201);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::uint64_t found = 0, listed_pairs = 0, by_boxes = 0;
  for (int i = 0; i < count; ++i) {
    std::vector<Body> begin, end;
    for (int b = 0; b < 12; ++b) {
      const auto at = [&] { return static_cast<double>(random.between(-12, 12)); };
      begin.push_back(
          body(std::to_string(b), ConvexPolyhedron(tests::points_in_cube(8, random)), shift(at(), at(), 0)));
      end.push_back(begin.back());
      end.back().parts[0].pose = shift(at(), at(), 0);
    }
    const SweptAnswer answer = meeting_on_the_way(begin, end);
    by_boxes += answer.counts.by_boxes;
    listed_pairs += answer.pairs.size();
    ASSERT_EQ(answer.counts.by_boxes + answer.counts.by_method, answer.counts.pairs);
    std::vector<Body> now = begin;
    for (int k = 0; k <= 64; ++k) {
      for (std::size_t b = 0; b < begin.size(); ++b) {  // exact: whole numbers, and 64 parts
        const auto &p = begin[b].parts[0].pose.affine().translation, &q = end[b].parts[0].pose.affine().translation;
        now[b].parts[0].pose = shift(p[0] + (q[0] - p[0]) * k / 64, p[1] + (q[1] - p[1]) * k / 64, 0);
      }
      for (const PartPair& pair : meeting_pairs(now).pairs) {
        if (!pair.meet()) continue;
        ++found;
        const auto there = std::find_if(answer.pairs.begin(), answer.pairs.end(), [&](const SweptPair& swept) {
          return swept.body_a == pair.body_a && swept.body_b == pair.body_b;
        });
        ASSERT_NE(there, answer.pairs.end());
        ASSERT_LE(there->time().low, k / 64.0);
      }
    }
  }
  EXPECT_GT(found, listed_pairs);
  EXPECT_GT(by_boxes, 0u);
  EXPECT_GT(listed_pairs, 0u);
}

// All at once against the two bodies of each pair alone: what is listed, and every count.
TEST(SceneSweep, IsWhatEachPairAloneIs) {
  const int count = tests::scaled_count(40, 10);
  Random random(tests::chosen_seed(20270202));
  std::uint64_t listed_pairs = 0, by_boxes = 0, at_ends_only = 0, all_allowed = 0;
  for (int round = 0; round < count; ++round) {
    std::vector<Body> begin(3 + random.below(12));
    for (Body& one : begin) {
      for (std::uint64_t p = random.below(4); p > 0; --p) {
        const auto at = [&] { return random.uniform(-4, 4); };
        one.parts.push_back({"", cube(), shift(at(), at(), at())});
      }
    }
    std::vector<Body> end = begin;
    for (Body& one : end) {
      for (Part& part : one.parts) {
        const auto at = [&] { return random.uniform(-4, 4); };
        const double turn = random.below(4) == 0 ? 0.5 : 0;
        part.pose = Pose::from_quaternion(1, 0, 0, turn, {at(), at(), at()});
      }
    }
    Question question;
    const auto some_body = [&] { return static_cast<std::uint32_t>(random.below(begin.size())); };
    for (std::uint64_t i = random.below(6); i > 0; --i) question.allowed.push_back({some_body(), some_body()});
    const SweptAnswer answer = meeting_on_the_way(begin, end, question);
    using Listed = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, bool, double, double>;
    const auto listed_of = [](const SweptPair& p) {
      const Interval time = p.time();
      return Listed{p.body_a, p.body_b, p.part_a, p.part_b, p.all_the_way(), time.low, time.high};
    };
    std::vector<Listed> expected, found;
    for (const SweptPair& pair : answer.pairs) found.push_back(listed_of(pair));
    SweptCounts counts;
    for (std::uint32_t a = 0; a < begin.size(); ++a) {
      for (std::uint32_t b = a + 1; b < begin.size(); ++b) {
        const auto is_pair = [&](const auto& pair) { return std::minmax(pair[0], pair[1]) == std::minmax(a, b); };
        Question alone;
        if (std::any_of(question.allowed.begin(), question.allowed.end(), is_pair)) alone.allowed = {{0, 1}};
        SweptAnswer one = meeting_on_the_way(std::vector{begin[a], begin[b]}, std::vector{end[a], end[b]}, alone);
        for (SweptPair& pair : one.pairs) {
          pair.body_a = a, pair.body_b = b;
          expected.push_back(listed_of(pair));
        }
        counts.pairs += one.counts.pairs, counts.allowed += one.counts.allowed;
        counts.by_boxes += one.counts.by_boxes, counts.by_method += one.counts.by_method;
        counts.at_ends_only += one.counts.at_ends_only, counts.meeting += one.counts.meeting;
      }
    }
    const SweptCounts& all = answer.counts;
    ASSERT_EQ(found, expected);
    ASSERT_EQ(all.pairs, counts.pairs);
    ASSERT_EQ(all.allowed, counts.allowed);
    ASSERT_EQ(all.by_boxes, counts.by_boxes);
    ASSERT_EQ(all.by_method, counts.by_method);
    ASSERT_EQ(all.at_ends_only, counts.at_ends_only);
    ASSERT_EQ(all.meeting, counts.meeting);
    ASSERT_EQ(all.pairs, all.allowed + all.by_boxes + all.by_method + all.at_ends_only);
    listed_pairs += answer.pairs.size(), by_boxes += all.by_boxes, at_ends_only += all.at_ends_only;
    all_allowed += all.allowed;
  }
  for (const std::uint64_t seen : {listed_pairs, by_boxes, at_ends_only, all_allowed}) {
    EXPECT_GT(seen, static_cast<std::uint64_t>(count));
  }
}

// Four boxes around a hole make a square frame of size 4. One face may be left out.
Part frame(bool is_open) {
  tests::Soup soup;
  soup.add_box({-2, -2, 0}, {4, 1, 1}, true, is_open);
  soup.add_box({-2, 1, 0}, {4, 1, 1}, true, false);
  soup.add_box({-2, -1, 0}, {1, 2, 1}, true, false);
  soup.add_box({1, -1, 0}, {1, 2, 1}, true, false);
  return {"frame", ConvexPolyhedron(soup.points), {}, std::make_shared<const solid::Mesh>(soup.mesh())};
}

TEST(SceneSweep, AsksAboutMeshesAsTheyAre) {
  std::vector<Body> begin{{"frame", {frame(false)}},
                          body("cube", cube(), shift(-0.5, -0.5, -4)),
                          body("ball", RoundBody::ball({}, 0.25), shift(0, 0, -8))};
  std::vector<Body> end = begin;
  end[1].parts[0].pose = shift(-0.5, -0.5, 4);  // through the hole
  SweptAnswer answer = meeting_on_the_way(begin, end);
  EXPECT_TRUE(answer.none_meet());
  EXPECT_EQ(answer.counts.surfaces_alone, 0u);
  Question every_pair;
  every_pair.every_pair = true;
  answer = meeting_on_the_way(begin, end, every_pair);
  ASSERT_EQ(answer.pairs.size(), 3u);
  EXPECT_TRUE(answer.pairs[0].is_of_meshes() && answer.pairs[0].all_the_way());
  EXPECT_FALSE(answer.pairs[1].is_of_meshes());
  std::vector<Body> hulls = begin, hulls_end = end;
  hulls[0].parts[0].mesh = hulls_end[0].parts[0].mesh = nullptr;
  EXPECT_TRUE(meeting_on_the_way(hulls, hulls_end).some_meet());
  // To a bar; and inside of one at the beginning.
  begin[1].parts[0].pose = shift(-0.5, -0.5, 0.25), end[1].parts[0].pose = shift(1.5, -0.5, 0.25);
  answer = meeting_on_the_way(begin, end);
  EXPECT_EQ(listed(answer), "0-1@0.25");
  EXPECT_TRUE(answer.pairs[0].is_of_meshes());
  EXPECT_EQ(std::get<MeshesMeetOnTheWay>(answer.pairs[0].evidence).point.x, 1);
  EXPECT_EQ(listed(meeting_on_the_way(end, begin)), "0-1@0.");
  // The answer counts frames that are open at a face. A ball is compared with the hull.
  begin[0] = end[0] = {"frame", {frame(true)}};
  begin[1].parts[0].pose = shift(-0.5, -0.5, -4), end[1].parts[0].pose = shift(-0.5, -0.5, 4);
  answer = meeting_on_the_way(begin, end);
  EXPECT_TRUE(answer.none_meet());
  EXPECT_EQ(answer.counts.surfaces_alone, 1u);
  end[2].parts[0].pose = shift(0, 0, 8);
  answer = meeting_on_the_way(begin, end);
  ASSERT_EQ(answer.pairs.size(), 2u);  // the ball meets the cube, too
  EXPECT_FALSE(answer.pairs[0].is_of_meshes());
  // One that turns is asked about at its ends, as it is.
  end[1].parts[0].pose = Pose::from_quaternion(1, 0, 0, 1, {0.5, -0.5, 0});
  end[2] = begin[2];
  answer = meeting_on_the_way(begin, end);
  EXPECT_EQ(answer.counts.at_ends_only, 2u);
  EXPECT_FALSE(answer.some_meet());
}

}  // namespace
}  // namespace sunder::scene
