// Writes what is proved of two polytopes into a certificate file (docs/claims.md): two bodies of points as statements
// `pair` of the table `bodies`, others as statements `polytopes` of the table of that name.
// Also called: proof logging.
// None throws, but for want of memory, or what the writer's sink throws.
#pragma once

#include <sunder/certificate/asked_pair.h>
#include <sunder/certificate/claims.h>
#include <sunder/polytope/pair/hyperplanes.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <span>
#include <string>

namespace sunder::polytope {

struct NamedPolytope {
  std::string name;  // empty: "unnamed"
  const Polytope& polytope;
  const Pose& pose;
  Said said{};  // what its rows are made of
};

// The table, and the statement: all of a file but its origin and its end. Requires the answer to be about these.
// Cost: linear, and exact_evidence().
void add_claims(ClaimsWriter& file, const NamedPolytope& a, const NamedPolytope& b, const PolytopeAnswer& answer);

// The same of B at each of these poses (that of `b` does not count), a statement and an answer each: A and B are
// written once. In the table, B at pose k has the name of B, and "at pose k".
void add_claims(ClaimsWriter& file, const NamedPolytope& a, const NamedPolytope& b, std::span<const Pose> poses,
                std::span<const PolytopeAnswer> answers);

// The same by several hyperplanes, as a statement `polytopes` `apart_by_hyperplanes`. Requires the evidence to be about
// these.
void add_claims(ClaimsWriter& file, const NamedPolytope& a, const NamedPolytope& b, const HyperplaneEvidence& evidence);

}  // namespace sunder::polytope

namespace sunder {

// Writes what polytope_polytope says of them as a certificate file, whole. Requires the answer to be about these.
void prove(const TextSink& sink, const AskedPair<polytope::Polytope, polytope::Pose>& asked,
           const polytope::PolytopeAnswer& answer);

}  // namespace sunder
