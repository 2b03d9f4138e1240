// Certificates of pairs, written by the library and checked without it: apart, in the plane also how far, and so far or
// not; touching or overlapping; of every family of nasty pairs. What the verifier accepts is proved, so this also
// checks polygon_polygon_contact, polygon_polygon_distance and polyhedron_polyhedron_contact.
#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>

#include <sunder/certificate/pair_claims.h>
#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::tests {
namespace {

struct Written {
  std::string text, verdict;
  std::size_t statements = 1;
  int kept = 0, broken = 0;  // of these, of clearances
};

// What the distance says of clearances that it keeps barely, and not quite.
void add_clearances(PairClaims& pairs, const planar::ClaimedPair& pair, const planar::PolygonDistance& distance,
                    Written& out) {
  const auto [low, high] = distance_of(distance);
  for (const double least : {low, high, std::nextafter(high, HUGE_VAL)}) {
    if (!(least > 0) || !std::isfinite(least)) continue;
    ++out.statements;
    planar::add_clearance(pairs, pair, distance, least);
    ++(planar::compare_distance(distance, least) == Sign::negative ? out.broken : out.kept);
  }
}

// The file of the pair alone, with how it lies.
template <class Asked>
Written proved(Asked asked, const PairAnswer& answer, Relation relation) {
  Written out;
  asked.tells_relation = true;
  prove([&](std::string_view piece) { out.text += piece; }, asked, answer);
  out.verdict = relation == Relation::none ? "apart" : std::string(name_of(relation));
  return out;
}

Written write(const PlanarCase& c) {
  const PairAnswer answer = planar::polygon_polygon(c.a, c.pose_a, c.b, c.pose_b);
  const Relation contact = planar::polygon_polygon_contact(c.a, c.pose_a, c.b, c.pose_b);
  if (answer.meet()) return proved(AskedPair{c.a, c.pose_a, c.b, c.pose_b}, answer, contact);
  Written out;
  ClaimsWriter file([&](std::string_view piece) { out.text += piece; });
  PairClaims pairs(file, PairClaims::Space::planar);
  const std::vector<Point3> in_a = in_space(c.a), in_b = in_space(c.b);
  const auto a = pairs.add_placed("a", pairs.add_body("a", in_a), planar::in_space(c.pose_a.affine()));
  const auto b = pairs.add_placed("b", pairs.add_body("b", in_b), planar::in_space(c.pose_b.affine()));
  out.verdict = "apart";
  const planar::ClaimedPair pair{a, b, c.a, c.pose_a, c.b, c.pose_b};
  planar::add_claims(pairs, pair, answer.evidence, contact);
  const planar::PolygonDistance distance = planar::polygon_polygon_distance(c.a, c.pose_a, c.b, c.pose_b);
  EXPECT_FALSE(distance.meet());
  if (distance.meet()) return out;
  planar::add_distance(pairs, pair, distance);
  ++out.statements;
  add_clearances(pairs, pair, distance, out);
  pairs.end();
  return out;
}

Written write(const PairCase& c) {
  return proved(AskedPair{c.a, c.pose_a, c.b, c.pose_b}, solid::polyhedron_polyhedron(c.a, c.pose_a, c.b, c.pose_b),
                solid::polyhedron_polyhedron_contact(c.a, c.pose_a, c.b, c.pose_b));
}

// Writes and checks the proofs of many pairs, and prints the verdicts of each family.
template <class Family, class Pairs>
void each_answer_is_proved(Pairs& pairs, int count, bool has_clearances) {
  std::map<Family, std::map<std::string, int>> tallies;
  std::map<std::string, int> total;
  for (int i = 0; i < count; ++i) {
    const auto c = pairs.next();
    const Written written = write(c);
    const auto result = sunder_verifier::verify_text(written.text, "certificate", sunder_verifier::Limit::none);
    ASSERT_EQ(result.statements.size(), written.statements)
        << i << " " << name_of(c.family) << result.failed_form << result.error;
    ASSERT_TRUE(result.accepted()) << i << " " << name_of(c.family) << ": " << result.statements[0].reason << "\n"
                                   << written.text.substr(0, 5000);
    ASSERT_EQ(result.statements[0].verdict, written.verdict);
    ++tallies[c.family][written.verdict];
    ++total[written.verdict];
    total["kept"] += written.kept;
    total["broken"] += written.broken;
  }
  for (const auto& [family, tally] : tallies) {
    std::printf("%-14s", std::string(name_of(family)).c_str());
    for (const auto& [verdict, n] : tally) std::printf(" %s %d", verdict.c_str(), n);
    std::printf("\n");
  }
  if (count < 500) return;
  for (const char* verdict : {"apart", "touching", "overlapping"}) EXPECT_GT(total[verdict], count / 20) << verdict;
  if (!has_clearances) return;
  std::printf("clearances: kept %d, broken %d\n", total["kept"], total["broken"]);
  EXPECT_GT(std::min(total["kept"], total["broken"]), count / 20);
}

TEST(PairCertificatesDifferential, EachAnswerInThePlaneIsProved) {
  const std::uint64_t seed = chosen_seed(20261123);
  SCOPED_TRACE("seed " + std::to_string(seed));
  PlanarPairs pairs(seed);
  each_answer_is_proved<PlanarFamily>(pairs, scaled_count(6000), true);
}

TEST(PairCertificatesDifferential, EachAnswerInSpaceIsProved) {
  const std::uint64_t seed = chosen_seed(20261124);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidPairs pairs(seed);
  each_answer_is_proved<Family>(pairs, scaled_count(3000), false);
}

}  // namespace
}  // namespace sunder::tests
