// Which arcs bound the common part of discs (docs/certificates-sets.md, "circles", B1 to B4): the twin of
// sunder_verify_arcs.py.
#pragma once

#include "disc.h"

#include <cstddef>
#include <vector>

namespace sunder_verifier {

// The point x, y, in a unit of which `unit` make one of the discs.
struct PointInUnits {
  Integer x, y, unit;
};

// Throws Refused where these arcs, one or more, are not what bounds the common part, counter-clockwise. Requires that
// the point is inside of the circles of all discs. Cost: for each arc and each disc the signs of a few numbers with a
// square root.
void check_arcs(const std::vector<Disc>& discs, const std::vector<std::size_t>& arcs, const PointInUnits& point);

}  // namespace sunder_verifier
