#include <sunder/base/contract.h>
#include <sunder/solid/round/round_claims.h>

namespace sunder::solid {

std::uint32_t add_shape(PairClaims& pairs, const std::string& name, const RoundBody& body) {
  return body.is_polyhedron() ? pairs.add_body(name, body.points())
                              : pairs.add_round_body(name, body.points(), body.kind(), body.radius());
}

std::uint32_t add_round(PairClaims& pairs, const std::string& name, const PlacedRound& placed) {
  return pairs.add_placed(name, add_shape(pairs, name, placed.body), placed.pose.affine());
}

void add_claims(PairClaims& pairs, std::uint32_t index_a, const PlacedRound& a, std::uint32_t index_b,
                const PlacedRound& b, const RoundEvidence& evidence, const RoundContact& contact) {
  SUNDER_REQUIRE(evidence.verdict != Verdict::undecided);
  if (evidence.verdict == Verdict::apart) return pairs.add_apart(index_a, index_b, direction_of(evidence));
  if (contact.contact == Contact::overlapping) return pairs.add_overlapping(index_a, index_b, contact.point);
  if (contact.contact == Contact::touching) {
    return pairs.add_touching(index_a, index_b, contact.point, contact.direction);
  }
  pairs.add_meet(index_a, index_b, common_point_of(a, b, evidence));
}

}  // namespace sunder::solid
