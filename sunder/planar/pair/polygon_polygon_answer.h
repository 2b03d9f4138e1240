// How every method answers whether two convex polygons meet: its search proposes, dispose() checks what it proposes,
// and where nothing holds finish() decides. Both are written here, once; both are exact.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/planar/pair/minkowski_difference_search.h>
#include <sunder/planar/pair/proposal.h>

namespace sunder::planar {

// Does the proposal hold? Fills in the certificate where it does. It may come from anywhere: what names no features of
// these polygons does not hold.
template <class A, class B>
bool dispose(const A& a, const B& b, const Proposal& p, PairCertificate& certificate, StageTally& tally) {
  const bool plain = p.claim == Proposal::Claim::meet_plainly;
  const auto are_corners = [plain](const auto& of, std::size_t count, std::uint32_t n) {
    const std::uint32_t end = plain ? n : 2 * n;
    return (plain ? count == 3 : count - 1 < 3) && of[0] < end && (count < 2 || of[1] < end) &&
           (count < 3 || of[2] < end);
  };
  if (!are_corners(p.of_a, p.count_a, a.size()) || !are_corners(p.of_b, p.count_b, b.size())) return false;
  const std::uint32_t i = p.of_a[0], j = p.of_b[0];
  switch (p.claim) {
    case Proposal::Claim::apart_by_edge_of_a:
      if (!parts(a, i, b, j, tally)) return false;
      certificate = apart_by_edge_of_a(a, i, b, j);
      return true;
    case Proposal::Claim::apart_by_edge_of_b:
      if (!parts(b, j, a, i, tally)) return false;
      certificate = apart_by_edge_of_b(a, i, b, j);
      return true;
    case Proposal::Claim::apart_at_vertices: return parts_at(a, i, b, j, certificate, tally);
    case Proposal::Claim::meet:
      return check_meet(a, {p.of_a.data(), p.count_a}, b, {p.of_b.data(), p.count_b}, certificate, tally);
    case Proposal::Claim::meet_plainly: return check_triangles(a, p.of_a, b, p.of_b, certificate, tally);
  }
  return false;
}

// Decides, whatever the polygons are. Cost: at most 4 (log2 n + log2 m) + 8 probes (minkowski_difference_search.h).
template <class A, class B>
void finish(const A& a, const B& b, PairCertificate& certificate, Cost& cost, StageTally& tally) {
  certificate = {};
  search_difference(a, 0, b, 0, certificate, cost, tally);
}

// The answer of a method that is exact from the start: nothing is proposed.
template <class A, class B>
PairAnswer answer_exactly(const A& a, const B& b) {
  PairAnswer answer;
  StageTally tally;
  finish(a, b, answer.evidence, answer.cost, tally);
  conclude(answer, tally.exact, false);
  return answer;
}

// The answer of a method that proposes: propose(holds, cost, tally) calls holds(proposal) until that is true, and tells
// whether it was. A search that is told that a proposal does not hold goes on where it is, or gives up. Points and
// segments are not proposed about.
template <class A, class B, class Propose>
PairAnswer answer_by(const A& a, const B& b, const Propose& propose) {
  if (a.size() < 3 || b.size() < 3) return answer_exactly(a, b);
  PairAnswer answer;
  StageTally tally;
  const auto holds = [&](const Proposal& proposal) {
    ++answer.cost.proposals;
    return dispose(a, b, proposal, answer.evidence, tally);
  };
  const bool held = propose(holds, answer.cost, tally);
  if (!held) finish(a, b, answer.evidence, answer.cost, tally);
  conclude(answer, tally.exact, !held);
  return answer;
}

}  // namespace sunder::planar
