// How deep bodies with a radius are in each other: what round_depth says is proved to the checker, from above and from
// below, and the two are near each other; and it is the same of swapped bodies.
#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>

#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/round/round_claims.h>
#include <sunder/solid/round/round_depth.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

namespace sunder::tests {
namespace {

using solid::PlacedRound;
using solid::RoundDepth;

struct RoundDepthTally {
  int all = 0, meet = 0, proved = 0, curved = 0, narrow = 0, with_low = 0;
};

TEST(RoundDepthDifferential, EachAnswerIsProved) {
  const std::uint64_t seed = chosen_seed(20261128);
  SCOPED_TRACE("seed " + std::to_string(seed));
  RoundPairs pairs(seed);
  const int count = scaled_count(1200);
  std::map<std::string, RoundDepthTally> tallies;
  for (int i = 0; i < count; ++i) {
    const RoundCase c = pairs.next();
    const PlacedRound a(c.a, c.pose_a), b(c.b, c.pose_b);
    const RoundDepth found = round_depth(a, b);
    SCOPED_TRACE(std::to_string(i) + " " + named(c));
    RoundDepthTally& tally = tallies[std::string(name_of(c.family))];
    ++tally.all;
    ASSERT_EQ(found.verdict(), round_round(a, b).verdict());
    const EnclosedDepth* depth = depth_of(found);
    if (depth == nullptr) continue;
    ++tally.meet;
    const auto [low, high] = depth->depth;
    ASSERT_TRUE(low >= 0 && low <= high) << low << " " << high;
    ASSERT_EQ(low == 0, std::holds_alternative<std::monostate>(depth->proof_of_low)) << low;
    const bool is_curved = c.a.is_curved() || c.b.is_curved();
    if (!is_curved) {
      ASSERT_LE(high, std::nextafter(low, HUGE_VAL));
    } else {
      ++tally.curved;
      const double size = std::max(size_of(a), size_of(b));
      tally.narrow += high - low <= std::max(0x1p-20 * high, 0x1p-38 * size);
      tally.with_low += low > 0;
    }
    const RoundDepth back = round_depth(b, a);
    ASSERT_TRUE(back.meet() || (is_curved && back.undecided()));
    if (const EnclosedDepth* other = depth_of(back)) {
      ASSERT_LE(other->depth.low, high);
      ASSERT_GE(other->depth.high, low);
    }
    if (!std::isfinite(high)) continue;
    ++tally.proved;
    const std::string text = claims_text({}, [&](ClaimsWriter& file) {
      PairClaims claims(file);
      const std::uint32_t first = add_round(claims, "a", a), second = add_round(claims, "b", b);
      add_claims(claims, first, a, second, b, round_round(a, b).evidence);
      add_depth(file, first, second, *depth);
    });
    const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
    ASSERT_TRUE(result.accepted()) << result.failed_form << result.error << low << " " << high << "\n"
                                   << (result.statements.empty() ? "" : result.statements.back().reason) << "\n"
                                   << text.substr(0, 3000);
    ASSERT_EQ(result.statements.size(), low > 0 ? 3u : 2u);
  }
  std::printf("%-14s %6s %6s %6s %7s %7s %8s\n", "family", "all", "meet", "proved", "curved", "narrow", "with low");
  RoundDepthTally total;
  for (const auto& [family, t] : tallies) {
    std::printf("%-14s %6d %6d %6d %7d %7d %8d\n", family.c_str(), t.all, t.meet, t.proved, t.curved, t.narrow,
                t.with_low);
    total.curved += t.curved;
    total.narrow += t.narrow;
    total.meet += t.meet;
  }
  if (count < 500) return;
  EXPECT_GT(total.meet, count / 3);
  EXPECT_GT(total.curved, count / 8);
  EXPECT_GT(total.narrow, total.curved / 2);
}

}  // namespace
}  // namespace sunder::tests
