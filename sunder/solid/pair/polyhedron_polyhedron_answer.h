// How every method answers whether two convex polyhedra meet: its search proposes, dispose() checks what it proposes,
// and where nothing holds finish() decides. Both are written once; both are exact.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/search/proposal.h>

namespace sunder::solid {

// Does the proposal hold? Fills in the certificate where it does. It may come from anywhere: what names no features of
// these bodies does not hold. A direction that is not three doubles is made by exact arithmetic, and counts as an exact
// sign; what a check walks over counts as probes. Allocates where a perpendicular parts the bodies.
bool dispose(const Placed& a, const Placed& b, const Proposal& proposal, PairCertificate& certificate, Cost& cost,
             StageTally& tally);

// Decides, whatever the bodies are (exact_simplex.h). Exact walks begin at these vertices; at others where there are no
// such ones. Allocates.
void finish(const Placed& a, const Placed& b, std::uint32_t near_a, std::uint32_t near_b, PairCertificate& certificate,
            Cost& cost, StageTally& tally);

// The answer of a method that proposes: propose(holds, cost) calls holds(proposal) until that is true, and tells
// whether it was. A search that is told that a proposal does not hold goes on where it is, or gives up.
PairAnswer answer_by(const Placed& a, const Placed& b, FunctionRef<bool(const Holds&, Cost&)> propose);

}  // namespace sunder::solid
