// Certificates of small nasty multipolygons under every rule, written by the library and checked without it: that they
// are valid, or each defect. What the verifier accepts is proved, so this also checks polygon_defects.
#include <tests/support/nasty_polygons.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <sunder/certificate/claims.h>
#include <sunder/planar/polygons/polygon_valid.h>
#include <sunder/planar/polygons/polygon_valid_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::tests {
namespace {

using planar::PolygonDefect;
using planar::PolygonRings;
using planar::PolygonRule;
using Parts = std::vector<PolygonRings>;

struct CertificateRates {
  std::map<std::string, int> verdicts;
  int unproved = 0;       // defects
  int only_unproved = 0;  // multipolygons none of whose defects is proved
};

void prove(const Parts& parts, PolygonRule rule, CertificateRates& rates) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.begin_table("polygons");
  planar::write_parts(file, parts);
  file.end_table();
  const planar::PolygonDefects answer = planar::polygon_defects(parts, {rule});
  std::size_t statements = 0;  // at most
  planar::ValidClaims claims(file, parts, 0, rule);
  if (answer.found.empty()) {
    claims.write_valid();
    ++statements;
  }
  for (const PolygonDefect& defect : answer.found) {
    const bool is_proved = claims.write_defect(defect);
    statements += is_proved ? 1 : 0;
    rates.unproved += is_proved ? 0 : 1;
  }
  if (statements == 0) {
    ++rates.only_unproved;
    return;
  }
  file.end();
  const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
  ASSERT_LE(result.statements.size(), statements) << result.failed_form << result.error;
  ASSERT_GE(result.statements.size(), 1u) << result.failed_form << result.error;
  for (const auto& one : result.statements) {
    ASSERT_TRUE(one.accepted) << one.sentence << ": " << one.failed_check << ": " << one.reason << "\n" << text;
    ++rates.verdicts[one.verdict];
  }
}

// Petals that meet in one point: as many defects as petals, which few statements tell of, within the checkers' limits.
TEST(ValidCertificates, ManyDefectsInOnePointAreFewStatements) {
  for (const PolygonRule rule : {PolygonRule::simple, PolygonRule::valid, PolygonRule::self_touch}) {
    std::vector<Point2> flower;
    constexpr std::uint32_t petals = 2000;
    for (std::uint32_t k = 0; k < petals; ++k) {
      const double n = petals;
      for (const Point2& p : {Point2{0, 0}, on_circle(k / n), on_circle((k + 0.5) / n)}) flower.push_back(p);
    }
    const Parts parts{{flower}};
    const planar::PolygonDefects answer = planar::polygon_defects(parts, {rule});
    EXPECT_GE(answer.found.size(), petals - 1);
    const std::string text = claims_text({}, [&](ClaimsWriter& file) {
      file.begin_table("polygons");
      planar::write_parts(file, parts);
      file.end_table();
      planar::ValidClaims claims(file, parts, 0, rule);
      for (const PolygonDefect& defect : answer.found) EXPECT_TRUE(claims.write_defect(defect));
    });
    const auto result = sunder_verifier::verify_text(text, "certificate");
    ASSERT_EQ(result.statements.size(), 1u) << result.error;
    EXPECT_TRUE(result.statements[0].accepted) << result.statements[0].reason;
  }
}

TEST(ValidCertificatesDifferential, EachAnswerIsProved) {
  const int count = scaled_count(4000);
  const std::uint64_t seed = chosen_seed(20261124);
  SCOPED_TRACE("seed " + std::to_string(seed));
  NastyPolygons polygons(seed);
  constexpr std::array<PolygonRule, 3> rules{PolygonRule::simple, PolygonRule::valid, PolygonRule::self_touch};
  std::array<CertificateRates, 3> rates;
  for (int k = 0; k < count; ++k) {
    const NastyFamily family = static_cast<NastyFamily>(k % nasty_family_count);
    const Parts parts = polygons.next(family);
    for (std::size_t r = 0; r < rules.size(); ++r) {
      ASSERT_NO_FATAL_FAILURE(prove(parts, rules[r], rates[r])) << k << " " << name_of(family) << " rule " << r;
    }
  }
  for (std::size_t r = 0; r < rules.size(); ++r) {
    std::printf("rule %d:", static_cast<int>(rules[r]));
    for (const auto& [verdict, n] : rates[r].verdicts) std::printf(" %s %d", verdict.c_str(), n);
    std::printf("; without a proof %d defects, and %d multipolygons\n", rates[r].unproved, rates[r].only_unproved);
  }
  if (count < 2000) return;
  for (const CertificateRates& rate : rates) {
    int proved = 0;
    for (const auto& [verdict, n] : rate.verdicts) proved += n;
    EXPECT_LE(rate.unproved, proved / 100);
    EXPECT_EQ(rate.only_unproved, 0);
    EXPECT_GT(rate.verdicts.at("valid"), count / 20);
  }
  for (const char* verdict : {"crosses", "falls_apart"}) EXPECT_GT(rates[2].verdicts[verdict], count / 1000) << verdict;
}

}  // namespace
}  // namespace sunder::tests
