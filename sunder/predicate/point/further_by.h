// Is one point so much further along a direction than another, or more? Exact.
// Also called: slab width, separation along an axis.
#pragma once

#include <sunder/number/exact_fraction.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/posed.h>

namespace sunder {

// Is `to` further along the direction than `from`, by that distance or more, in the unit of the world? squared: of the
// distance, which is not negative. The points may be of two bodies.
bool is_further_by(const WorldDirection& direction, const Posed3& from, const Posed3& to, const ExactFraction& squared);

}  // namespace sunder
