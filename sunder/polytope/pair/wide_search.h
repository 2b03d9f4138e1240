// Half-spaces and points whose numbers differ by more than a double's exponents do: the search of
// half_space_point_game.h in long floating point (wide_game.h). It names the few half-spaces and points that matter;
// their exact weights prove.
#pragma once

#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/placed.h>

#include <optional>

namespace sunder::polytope {

// Nothing where the numbers are not so, or no proof is found. Cost: games of 32 half-spaces and 32 points, and of those
// that come in, of some million products at most, of numbers of as many bits as exponents differ by, or some times as
// many. Of d = 6, 20 of each, and exponents to +-1000 some 30 ms. Allocates.
std::optional<ExactDecision> search_widely(Placed& half_spaces, Placed& points, Cost& cost);

}  // namespace sunder::polytope
