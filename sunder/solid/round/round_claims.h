// What round_round says of two bodies, in certificate files (docs/claims.md, "pair", "clearance").
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/asked_pair.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/round/round_contact.h>
#include <sunder/solid/round/round_round.h>

#include <cstdint>
#include <string>

namespace sunder::solid {

// Adds the body to the table, where its points are; returns its index. Keeps a view of the points, which must stay.
std::uint32_t add_shape(PairClaims& pairs, const std::string& name, const RoundBody& body);

// Adds the placed body to the table; returns its index. Keeps a view of the body's points, which must stay.
std::uint32_t add_round(PairClaims& pairs, const std::string& name, const PlacedRound& body);

// States that they are apart; that they touch, or overlap, where the contact tells; else that they meet. Requires that
// it is decided whether they do.
void add_claims(PairClaims& pairs, std::uint32_t index_a, const PlacedRound& a, std::uint32_t index_b,
                const PlacedRound& b, const RoundEvidence& evidence, const RoundContact& contact = {});

}  // namespace sunder::solid

namespace sunder {

// Writes what round_round says of them as a certificate file, whole. Requires an answer about these, which is not
// undecided. Throws Error as round_round.
void prove(const TextSink& sink, const AskedPair<solid::RoundBody, solid::Pose>& asked,
           const solid::RoundAnswer& answer);

}  // namespace sunder
