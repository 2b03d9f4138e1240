// The exact finishing of the question whether two polyhedra meet while they are translated: the simplex method in
// integers, with the vertex graphs as its pricing, as in exact_simplex.h.
//
// The linear program: weights l_i >= 0 of A's vertices, m_j >= 0 of B's, and s0, s1 >= 0 of the two ends of time, with
//   sum l_i x_i - sum m_j y_j + s0 v_0 + s1 v_1 = 0,  sum l_i = 1,  sum m_j = 1,  s0 + s1 = 1
// over the exact images x_i, y_j under the linear parts alone, and v_k, the translation of A less that of B at time k.
// So s1 is a time at which they meet, and translations of both bodies are never rounded. Phase one minimises the sum of
// six artificial variables. Its multipliers (d, alpha, beta, gamma) end with a price that is not positive for any
// column, and if the sum is positive, then d (x_i + v_k) <= -alpha - gamma < beta <= d y_j: d parts the bodies at both
// ends.
//
// The first time is the least s1: what counts besides the artificial sum, where that is equal. Costs are pairs,
// compared as words are in a dictionary, and so are prices; a direction that has both parts is made of integers, with a
// factor for the first part that is more than the second can outweigh. At the end, with D its spatial part and t the
// least s1, for all i and j and each time s
//   D y_j - D (x_i + (1 - s) v_0 + s v_1) >= (t - s) times a positive number:
// D parts the bodies before t, and not at t.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/exact/sweep_contact.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/translation.h>

#include <array>
#include <cstdint>
#include <optional>

namespace sunder::solid {

// What was found: a contact, or a direction that parts the bodies at both ends and vertices that are extreme along it.
struct SweepOutcome {
  std::optional<SweepContact> contact;
  std::array<Dyadic, 3> direction{};
  std::uint32_t extreme_a = 0, extreme_b = 0;
};

enum class SweepTime : std::uint8_t { any, first };

// Decides; never fails. near_a, near_b: vertices to try first. Allocates.
SweepOutcome decide_by_sweep_simplex(const ConvexPolyhedron& a, const Translation& of_a,  //
                                     const ConvexPolyhedron& b, const Translation& of_b, SweepTime wanted,
                                     std::uint32_t near_a, std::uint32_t near_b, Cost& cost, StageTally& tally);

}  // namespace sunder::solid
