// Bodies with a radius: what round_round says, against fractions that check its evidence by the page's definitions, and
// against what is known of the pairs.
#include <tests/support/round_oracle.h>
#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>

#include <sunder/solid/round/round_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>

namespace sunder::tests {
namespace {

using solid::PlacedRound;
using solid::RoundAnswer;

struct RoundPairTally {
  int apart = 0, meet = 0, undecided = 0, finished = 0;
};

// Is it decided always, as the header says?
bool is_decided(const RoundCase& c) {
  const bool curved_a = c.a.is_curved(), curved_b = c.b.is_curved();
  if (!curved_a && !curved_b) return true;
  const auto is_cone = [](const solid::RoundBody& body) { return body.kind() == RoundKind::cone; };
  return (c.a.is_polyhedron() || c.b.is_polyhedron()) && !is_cone(c.a) && !is_cone(c.b);
}

// Is the gap or the depth of an undecided pair below 2^-40 of its size? Moved by that much across the direction given,
// B has to be apart from A, and moved back it has to meet it.
bool is_close(const RoundCase& c, const RoundAnswer& answer) {
  const double size = std::max(size_of(PlacedRound(c.a, c.pose_a)), size_of(PlacedRound(c.b, c.pose_b)));
  if (size > 1e100 && c.family == RoundFamily::degenerate) return true;  // a radius of 1e200
  const Point3& d = std::get<solid::NearlyTouching>(answer.evidence).direction;
  const double largest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  const Point3 e{d.x / largest, d.y / largest, d.z / largest};
  const double by = 0x1p-40 * size / std::sqrt(e.x * e.x + e.y * e.y + e.z * e.z);
  const auto verdict = [&](double t) { return round_round(c.a, c.pose_a, c.b, moved(c.pose_b, e, t)).verdict(); };
  return verdict(by) == Verdict::apart && verdict(-by) == Verdict::meet;
}

TEST(RoundPairDifferential, EachAnswerIsProved) {
  const std::uint64_t seed = chosen_seed(20261126);
  SCOPED_TRACE("seed " + std::to_string(seed));
  RoundPairs pairs(seed);
  const int count = scaled_count(20000);
  std::map<std::string, RoundPairTally> tallies;
  for (int i = 0; i < count; ++i) {
    const RoundCase c = pairs.next();
    const RoundAnswer answer = round_round(c.a, c.pose_a, c.b, c.pose_b);
    RoundPairTally& tally = tallies[std::string(name_of(c.family))];
    ++(answer.undecided() ? tally.undecided : answer.meet() ? tally.meet : tally.apart);
    if (answer.decided_by == DecidedBy::finishing) ++tally.finished;
    if (is_decided(c)) {
      ASSERT_FALSE(answer.undecided()) << i << " " << named(c);
    }
    if (c.family == RoundFamily::touching) {
      ASSERT_NE(answer.verdict(), Verdict::apart) << i << " " << named(c);
      if (c.a.is_polyhedron() || c.b.is_polyhedron()) {
        ASSERT_TRUE(answer.meet()) << i << " " << named(c);
      }
    }
    if (answer.undecided()) {
      ASSERT_TRUE(is_close(c, answer)) << i << " " << named(c);
      continue;
    }
    const PlacedRound a(c.a, c.pose_a), b(c.b, c.pose_b);
    ASSERT_TRUE(is_proved(a, b, answer.evidence))
        << i << " " << named(c) << " " << name_of(answer.verdict()) << " by " << answer.evidence.index();
  }
  const std::map<std::string, double> most_undecided{{"general", 0.001},     {"nested", 0.001},      {"touching", 0.02},
                                                     {"grid", 0.02},         {"near_contact", 0.06}, {"last_bit", 0.08},
                                                     {"tiny_or_huge", 0.04}, {"degenerate", 0.05}};
  for (const auto& [family, t] : tallies) {
    const int all = t.apart + t.meet + t.undecided;
    if (all >= 500) {
      EXPECT_LE(t.undecided, most_undecided.at(family) * all) << family;
      EXPECT_GT(t.meet, all / 10) << family;
      if (family != "touching") {
        EXPECT_GT(t.apart, all / 10) << family;
      }
    }
    std::printf("%-13s apart %d, meet %d, undecided %d, finished exactly %d\n", family.c_str(), t.apart, t.meet,
                t.undecided, t.finished);
  }
}

// The same as certificate files, for a checker that knows nothing of the library.
TEST(RoundPairDifferential, TheVerifierAcceptsEachProof) {
  const std::uint64_t seed = chosen_seed(20261127);
  SCOPED_TRACE("seed " + std::to_string(seed));
  RoundPairs pairs(seed);
  const int count = scaled_count(4000);
  std::map<std::string, int> tally;
  for (int i = 0; i < count; ++i) {
    const RoundCase c = pairs.next();
    const PlacedRound a(c.a, c.pose_a), b(c.b, c.pose_b);
    const RoundAnswer answer = round_round(c.a, c.pose_a, c.b, c.pose_b);
    if (answer.undecided()) continue;
    const solid::RoundContact contact = round_round_contact(a, b, answer.evidence);
    std::string text;
    AskedPair asked{c.a, c.pose_a, c.b, c.pose_b};
    asked.tells_relation = true;
    prove([&](std::string_view piece) { text += piece; }, asked, answer);
    std::string_view verdict = name_of(answer.verdict());
    if (relation_of(contact) != Relation::none) verdict = name_of(relation_of(contact));
    ++tally[std::string(verdict)];
    const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
    ASSERT_EQ(result.statements.size(), 1) << i << " " << named(c) << result.failed_form << result.error;
    ASSERT_TRUE(result.accepted()) << i << " " << named(c) << ": " << result.statements[0].reason << "\n"
                                   << text.substr(0, 3000);
    ASSERT_EQ(result.statements[0].verdict, verdict);
    if (answer.meet() && relation_of(contact) == Relation::none) {
      const bool hulls = !c.a.is_curved() && !c.b.is_curved();
      ASSERT_FALSE(hulls || is_decided(c)) << i << " " << named(c);
    }
    if (c.family == RoundFamily::touching) {
      ASSERT_NE(verdict, "overlapping") << i << " " << named(c);
    }
  }
  for (const auto& [verdict, n] : tally) std::printf("%s %d\n", verdict.c_str(), n);
  if (count < 500) return;
  for (const char* verdict : {"apart", "touching", "overlapping"}) EXPECT_GT(tally[verdict], count / 20) << verdict;
  EXPECT_LT(tally["meet"], count / 25) << "it is not known whether they touch or overlap";
}

bool is_accepted(const RoundCase& c, const solid::RoundEvidence& evidence, void (*spoil)(CommonPoint&) = nullptr) {
  const PlacedRound a(c.a, c.pose_a), b(c.b, c.pose_b);
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims claims(file);
  const std::uint32_t index_a = add_round(claims, "a", a), index_b = add_round(claims, "b", b);
  if (spoil == nullptr) {
    add_claims(claims, index_a, a, index_b, b, evidence);
  } else {
    CommonPoint point = common_point_of(a, b, evidence);
    spoil(point);
    claims.add_meet(index_a, index_b, point);
  }
  claims.end();
  return sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none).accepted();
}

// What is not true is refused: the other verdict with the same numbers, a direction turned round, a point that is not
// where its weights put it, weights that do not sum to 1.
TEST(RoundPairDifferential, TheVerifierRefusesWhatIsNotTrue) {
  const std::uint64_t seed = chosen_seed(20261128);
  SCOPED_TRACE("seed " + std::to_string(seed));
  RoundPairs pairs(seed);
  const int count = scaled_count(2000);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    const RoundCase c = pairs.next();
    const RoundAnswer answer = round_round(c.a, c.pose_a, c.b, c.pose_b);
    if (answer.undecided()) continue;
    solid::RoundEvidence other = answer.evidence;
    ASSERT_TRUE(is_accepted(c, answer.evidence)) << i << " " << named(c);
    if (answer.meet()) {
      other = solid::SeparatingDirection{{1, 0.25, -0.5}};
      ASSERT_FALSE(is_accepted(c, other)) << i << " " << named(c);
      ASSERT_FALSE(is_accepted(
          c, answer.evidence,
          [](CommonPoint& x) { x.of_a.parts[0].numerator = x.of_a.parts[0].numerator + x.of_a.denominator; }))
          << i << " " << named(c);
      ASSERT_FALSE(
          is_accepted(c, answer.evidence, [](CommonPoint& x) { x.at.x = x.at.x + x.at.denominator.scaled(1000); }))
          << i << " " << named(c);
      refused += 3;
    } else {
      const Point3 d = near_direction(PlacedRound(c.a, c.pose_a), PlacedRound(c.b, c.pose_b), answer.evidence);
      other = solid::SeparatingDirection{{-d.x, -d.y, -d.z}};
      ASSERT_FALSE(is_accepted(c, other)) << i << " " << named(c);
      ++refused;
    }
  }
  std::printf("%d refused\n", refused);
  EXPECT_GT(refused, count);
}

}  // namespace
}  // namespace sunder::tests
