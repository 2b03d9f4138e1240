// The exact finishing of pair questions in R^d: small linear programs in integers, whose columns are found by scans.
// Also called: revised simplex method with column generation; cutting planes.
//
// Two bodies of points: weights l, m >= 0 with
//   sum l_i a_i - sum m_j b_j = 0,  sum l_i = 1,  sum m_j = 1.
// The multipliers (y, s, t) price a point of A at y . a_i + s, one of B at -y . b_j + t: an extreme point is best.
// Where none pays, the sum is zero, or y parts the bodies:  y . a_i <= -s < t <= y . b_j.
//
// Two bodies of half-spaces a . x <= b: multipliers l >= 0 that contradict,
//   sum l_i a_i = 0,  sum l_i b_i = -1.
// Where there are none, the multipliers (y, z) of this program have z > 0, and y / z keeps all half-spaces (Farkas).
//
// Half-spaces A and points B: for some of the half-spaces, weights m >= 0 of points with
//   sum m_j (a_i . b_j - b_i) + s_i = 0, s_i >= 0,  sum m_j = 1.
// If there are none, the multipliers make a combination of these half-spaces that has no point of B. Else
// x = sum m_j b_j is a common point, if it breaks no other half-space; the one that it breaks most is added.
#pragma once

#include <sunder/polytope/pair/evidence.h>
#include <sunder/polytope/pair/placed.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace sunder::polytope {

struct ExactDecision {
  Verdict verdict = Verdict::apart;
  std::shared_ptr<const ExactEvidence> evidence;
};
inline ExactDecision proved(Verdict verdict, ExactEvidence evidence) {
  return {verdict, std::make_shared<const ExactEvidence>(std::move(evidence))};
}

// The same of B and A.
ExactDecision exchanged(ExactDecision decision);

// Decides; never fails. Rows named are tried first: they need not be of any use. tree_scans grows by the nodes of trees
// that were looked at whole (TreeWalk::scans). Allocates.
ExactDecision decide_exactly(Placed a, Placed b, std::span<const std::uint32_t> of_a,
                             std::span<const std::uint32_t> of_b, Cost& cost, std::uint32_t* tree_scans = nullptr);

// The same of two bodies of points, from those named: nothing where it takes more than `most` steps, each with a
// furthest point of each body, to correct what the named ones prove.
std::optional<ExactDecision> decide_by_few(Placed& a, Placed& b, std::span<const std::uint32_t> of_a,
                                           std::span<const std::uint32_t> of_b, std::uint32_t most, Cost& cost);

// The common point of the hulls of these points. Requires that there is one.
ExactEvidence common_point_of(Placed a, Placed b, std::span<const std::uint32_t> of_a,
                              std::span<const std::uint32_t> of_b);

}  // namespace sunder::polytope
