// Exact weights of a common point of two hulls of few points, by determinants: what a search in floating point proposes
// becomes a proof, or is refused, at the cost of some small determinants.
// Also called: Cramer's rule; Caratheodory's theorem (d + 2 points are enough).
#pragma once

#include <sunder/polytope/pair/evidence.h>

#include <cstdint>
#include <optional>
#include <span>

namespace sunder::polytope {

// The rows named of two bodies of points, each once.
struct NamedPoints {
  std::span<const std::uint32_t> of_a, of_b;
};

// The common point of the hulls of these points, as evidence of `meet`, with at most d + 2 points that have a weight;
// nothing where none is found, which tells nothing. Where not all points have weights, or weights are not unique, it is
// floating point that says which points matter. All signs are those of exact numbers.
//   Weights l of A's points and m of B's that sum to 1 each, with sum l_i a_i = sum m_j b_j, are those of a relation
//   sum_{i>0} l_i (a_i - a_0) + sum_{j>0} m_j (b_0 - b_j) + (a_0 - b_0) = 0 of n + 1 <= d + 1 vectors
//   (null_vector_internal.h).
// Cost: that of null_vector().
// Requires one dimension of all.
std::optional<ExactEvidence> common_point_by_determinants(const Polytope& a, const Pose& pose_a, const Polytope& b,
                                                          const Pose& pose_b, NamedPoints named);

}  // namespace sunder::polytope
