// sunder pair where one of A and B is a line, a ray or a half-plane, and the other one a point, segment or polygon.
#pragma once

#include <sunder/ask/pair/pair_planar_input.h>

namespace sunder::ask {

// Prints what the two have in common; returns the exit code. Requires one of them, or both, to be unbounded. Throws
// Error for bad input: two unbounded objects; --distance or --clearance; a pose of the unbounded object under which one
// of its two points is no pair of doubles. origin: for the certificate.
int run_unbounded_pair(const PairCall& call, const PlanarInput& a, const PlanarInput& b, const LeftOutList& left_out,
                       Origin origin);

}  // namespace sunder::ask
