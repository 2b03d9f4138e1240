// Weights of half-spaces, or of points, as a proof: whoever has proposed them, exact numbers say whether they are one.
#pragma once

#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/placed.h>

#include <optional>
#include <span>

namespace sunder::polytope {

// Is this combination of points inside of all half-spaces? Nothing where it is not, or a weight is negative.
std::optional<ExactDecision> met_by_weights(Placed& half_spaces, Placed& points,
                                            std::span<const Weights::Part> of_points, Cost& cost);

// Is no point in this combination of half-spaces? Nothing where one is. Requires weights >= 0.
std::optional<ExactDecision> parted_by_weights(Placed& half_spaces, Placed& points,
                                               std::span<const Weights::Part> of_half_spaces, Cost& cost);

}  // namespace sunder::polytope
