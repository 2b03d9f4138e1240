#include <sunder/base/contract.h>
#include <sunder/solid/round/round_claims.h>

namespace sunder::solid {

std::uint32_t add_shape(PairClaims& pairs, const std::string& name, const RoundBody& body) {
  return reach_beyond_core(body) > 0 ? pairs.add_round_body(name, body.points(), body.kind(), body.radius())
                                     : pairs.add_body(name, body.points());
}

std::uint32_t add_round(PairClaims& pairs, const std::string& name, const PlacedRound& placed) {
  return pairs.add_placed(name, add_shape(pairs, name, placed.body), placed.pose.affine());
}

void add_claims(PairClaims& pairs, std::uint32_t index_a, const PlacedRound& a, std::uint32_t index_b,
                const PlacedRound& b, const RoundEvidence& evidence, const RoundContact& contact) {
  SUNDER_REQUIRE(verdict_of(evidence) != Verdict::undecided);
  if (verdict_of(evidence) == Verdict::apart) return pairs.add_apart(index_a, index_b, direction_of(a, b, evidence));
  if (const auto* inside = std::get_if<OverlappingAt>(&contact)) {
    return pairs.add_overlapping(index_a, index_b, inside->point);
  }
  if (const auto* touching = std::get_if<TouchingAt>(&contact)) {
    return pairs.add_touching(index_a, index_b, touching->point, touching->direction);
  }
  pairs.add_meet(index_a, index_b, common_point_of(a, b, evidence));
}

}  // namespace sunder::solid

namespace sunder {

void prove(const TextSink& sink, const AskedPair<solid::RoundBody, solid::Pose>& asked,
           const solid::RoundAnswer& answer) {
  const solid::PlacedRound a(asked.a, asked.at_a), b(asked.b, asked.at_b);
  ClaimsWriter file(sink);
  file.add_origin(asked.origin);
  PairClaims pairs(file);
  const std::uint32_t index_a = add_round(pairs, asked.name_a, a), index_b = add_round(pairs, asked.name_b, b);
  solid::RoundContact contact;
  if (asked.tells_relation) contact = round_round_contact(a, b, answer.evidence);
  add_claims(pairs, index_a, a, index_b, b, answer.evidence, contact);
  pairs.end();
}

}  // namespace sunder
