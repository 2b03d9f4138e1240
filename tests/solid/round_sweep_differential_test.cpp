// Bodies with a radius that go straight: what round_round_sweep says, against the checker of certificate files, against
// polyhedra on exact grids, and against itself where the way is shifted sideways.
#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>

#include <sunder/solid/round/round_claims.h>
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_round_sweep.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace sunder::tests {
namespace {

using solid::PlacedRound;
using solid::Pose;
using solid::RoundBody;
using solid::RoundFirstContact;
using solid::SweepAnswer;
using solid::Translation;

struct Motion {
  RoundBody a, b;
  Translation of_a, of_b;

  bool are_hulls() const { return !a.is_curved() && !b.is_curved(); }
  bool are_polyhedra() const { return a.is_polyhedron() && b.is_polyhedron(); }
  SweepAnswer ask() const { return round_round_sweep(a, of_a, b, of_b); }
};

Point3 some_way(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// The pair of the case is what they are at some time between.
Motion through(const RoundCase& c, Random& random) {
  const double size = std::max(size_of(PlacedRound(c.a, c.pose_a)), size_of(PlacedRound(c.b, c.pose_b)));
  const double longest = std::min(size, 1e100) * (random.below(3) == 0 ? 0.1 : 3);
  const auto way = [&](const Pose& at) {
    const Point3 d = some_way(random, longest);
    return Translation(moved(at, d, -random.uniform(0, 1)), moved(at, d, random.uniform(0, 1)));
  };
  return {c.a, c.b, way(c.pose_a), random.below(2) == 0 ? Translation(c.pose_b) : way(c.pose_b)};
}

// As a file, for a checker that knows nothing of the library.
sunder_verifier::FileResult checked(const Motion& m, const SweepAnswer& answer, const RoundFirstContact* first) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims pairs(file);
  const PlacedRound a(m.a, m.of_a.begin()), to_a(m.a, m.of_a.end()), b(m.b, m.of_b.begin()), to_b(m.b, m.of_b.end());
  const auto add = [&](const RoundBody& body, const PlacedRound& begin, const PlacedRound& end) {
    const std::uint32_t base = add_shape(pairs, "base", body);
    const std::uint32_t at_begin = pairs.add_placed("begin", base, begin.pose.affine());
    return std::pair(at_begin, pairs.add_placed("end", base, end.pose.affine()));
  };
  const auto [of_a, end_a] = add(m.a, a, to_a);
  const auto [of_b, end_b] = add(m.b, b, to_b);
  add_claims(pairs, {of_a, of_b, end_a, end_b}, m.a, m.of_a, m.b, m.of_b, answer);
  if (first != nullptr) add_claims(pairs, {of_a, of_b, end_a, end_b}, *first);
  pairs.end();
  return sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
}

struct RoundSweepTally {
  int apart = 0, meet = 0, between = 0, undecided = 0, finished = 0;
};

TEST(RoundSweepDifferential, EachAnswerIsProved) {
  const std::uint64_t seed = chosen_seed(20261127);
  SCOPED_TRACE("seed " + std::to_string(seed));
  RoundPairs pairs(seed);
  Random random(seed);
  const int count = scaled_count(2000);
  std::map<std::string, RoundSweepTally> tallies;
  int narrow = 0, firsts = 0;
  for (int i = 0; i < count; ++i) {
    const RoundCase c = pairs.next();
    std::optional<Motion> some;
    try {
      some = through(c, random);
    } catch (const Error&) {  // beyond the doubles
      continue;
    }
    const Motion& m = *some;
    const SweepAnswer answer = m.ask();
    RoundSweepTally& tally = tallies[std::string(name_of(c.family))];
    ++(answer.undecided() ? tally.undecided : answer.meet() ? tally.meet : tally.apart);
    tally.finished += answer.decided_by == DecidedBy::finishing;
    if (answer.undecided()) {
      ASSERT_FALSE(m.are_hulls()) << i << " " << named(c);
      continue;
    }
    std::optional<RoundFirstContact> first;
    if (answer.meet()) {
      first = round_round_first_contact(m.a, m.of_a, m.b, m.of_b, answer);
      const Interval found = contact_of(m.a, m.of_a, m.b, m.of_b, answer).time.enclosure();
      tally.between += found.low > 0 && found.high < 1;
      ASSERT_LE(0, first->time.low);
      ASSERT_LE(first->time.low, first->time.high);
      ASSERT_LE(first->time.high, found.high) << i << " " << named(c);
      ASSERT_EQ(first->contact.time.enclosure().high, first->time.high);
      ++firsts;
      narrow += first->time.high - first->time.low <= 0x1p-36;
    }
    const auto result = checked(m, answer, first ? &*first : nullptr);
    ASSERT_TRUE(result.accepted()) << i << " " << named(c) << " " << name_of(answer.verdict()) << ": "
                                   << result.failed_form << result.error
                                   << (result.statements.empty() ? "" : result.statements[0].reason);
  }
  RoundSweepTally all;
  for (const auto& [family, t] : tallies) {
    std::printf("%-13s apart %d, meet %d (between the ends %d), undecided %d, finished exactly %d\n", family.c_str(),
                t.apart, t.meet, t.between, t.undecided, t.finished);
    all.apart += t.apart, all.meet += t.meet, all.between += t.between, all.undecided += t.undecided;
  }
  std::printf("first times: %d, of which %d within 2^-36\n", firsts, narrow);
  if (count < 150) return;
  EXPECT_GT(all.apart, count / 20);
  EXPECT_GT(all.between, count / 20);
  EXPECT_LT(all.undecided, count / 20);
  EXPECT_GT(narrow, firsts / 2);
}

// B goes past A, sideways by more and more: where does it cease to meet it? Of hulls it is said of neighbouring doubles
// that one does and the next does not; of others what is undecided between is narrow.
TEST(RoundSweepDifferential, GrazesToTheLastBit) {
  const std::uint64_t seed = chosen_seed(20261128);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int count = scaled_count(40);
  int hulls = 0, curved = 0, finished = 0, undecided = 0;
  for (int i = 0; i < count; ++i) {
    const auto primitive = [&] { return static_cast<Primitive>(random.below(primitive_count)); };
    const RoundBody a = some_primitive(primitive(), random), b = some_primitive(primitive(), random);
    if (a.is_polyhedron() && b.is_polyhedron()) continue;
    const Pose turn = Pose::from_quaternion(random.uniform(-1, 1), random.uniform(-1, 1), 0.6, 0.3, {});
    const Point3 way = some_way(random, 10), sideways = some_way(random, 10);
    const auto motion = [&](double by) {
      const Pose middle = moved(turn, sideways, by);
      return Motion{a, b, Translation(Pose()), {moved(middle, way, -0.75), moved(middle, way, 1)}};
    };
    const auto last = [&](double low, bool undecided_meets) {
      double high = 2;
      for (double mid = low + (high - low) / 2; mid > low && mid < high; mid = low + (high - low) / 2) {
        const SweepAnswer answer = motion(mid).ask();
        (answer.meet() || (undecided_meets && answer.undecided()) ? low : high) = mid;
      }
      return low;
    };
    if (!motion(0).ask().meet() || motion(2).ask().verdict() != Verdict::apart) continue;
    const double meets = last(0, false), apart = std::nextafter(last(meets, true), 3.0);
    const Motion near = motion(meets), far = motion(apart);
    const SweepAnswer answer = near.ask(), other = far.ask();
    ASSERT_TRUE(answer.meet());
    ASSERT_EQ(other.verdict(), Verdict::apart);
    ASSERT_TRUE(checked(near, answer, nullptr).accepted()) << i;
    ASSERT_TRUE(checked(far, other, nullptr).accepted()) << i;
    if (near.are_hulls()) {
      ASSERT_EQ(apart, std::nextafter(meets, 3.0)) << i;
      finished += answer.decided_by == DecidedBy::finishing || other.decided_by == DecidedBy::finishing;
      ++hulls;
    } else {
      ASSERT_LE(apart - meets, 0x1p-36) << i;
      undecided += apart > std::nextafter(meets, 3.0);
      ++curved;
    }
  }
  std::printf("hulls %d, of which finished exactly %d; curved %d, of which some are undecided between %d\n", hulls,
              finished, curved, undecided);
  if (count < 25) return;
  EXPECT_GT(hulls, count / 10);
  EXPECT_GT(curved, count / 4);
  EXPECT_GT(finished, 0);
}

}  // namespace
}  // namespace sunder::tests
