// Half-spaces and points, as a matrix game in floating point. It proposes, and exact numbers dispose of it.
//
// The payoff of point b_j against half-space a_i . x <= b_i is a_i . b_j - b_i. Where the value of this matrix game is
// negative, the weights of points make a point inside of all half-spaces; where it is positive, the weights of
// half-spaces make one that no point is in. It is solved for few rows and columns, and the best replies of either side,
// found by scans, come in. Where one half-space has all weight and the points reach just to it, exact products tell
// whether they touch it. Also called: double oracle method (McMahan, Gordon & Blum 2003); column and row generation.
#pragma once

#include <sunder/polytope/pair/exact_simplex.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace sunder::polytope {

struct HalfSpaceProposal {
  std::optional<ExactDecision> decision;    // proved; else nothing is known
  std::vector<std::uint32_t> of_a, of_b{};  // where not: rows that matter, likely
};

// `of_a` are half-spaces, `of_b` points. Requires bodies of these kinds. Cost: a scan of both bodies, or of samples or
// shortlists, a step; some 2 d to 4 d steps.
HalfSpaceProposal propose_by_game(const Polytope& half_spaces, const Pose& pose, const Polytope& points,
                                  const Pose& pose_of_points, Cost& cost);

}  // namespace sunder::polytope
