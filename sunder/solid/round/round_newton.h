// The direction along which the pieces that a simplex is of are furthest apart, or least deep in each other: where the
// reaches of these are equal, by Newton's method, and the derivative of the gap vanishes along what is left of the
// sphere. For the sources of solid/round.
#pragma once

#include <sunder/solid/round/round_proposals.h>
#include <sunder/solid/search/closest_simplex.h>

#include <array>
#include <utility>

namespace sunder::solid::round_quick {

// What the vertices of a simplex are differences of, by their number there.
using Slots = std::array<std::pair<Far, Far>, 5>;

// d: about that direction, of any length. True: decided. Cost: at most 16 steps.
bool refine(Proposals& pair, const DifferenceSimplex& simplex, const Slots& slots, const V& d);

}  // namespace sunder::solid::round_quick
