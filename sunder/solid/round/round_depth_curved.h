// The depth of two bodies of which one is a cylinder, a cone or an ellipsoid. For round_depth.cpp.
#pragma once

#include <sunder/solid/round/round_depth.h>

namespace sunder::solid {

// Requires that the bodies meet, and that one is curved. Adds to `cost`.
EnclosedDepth depth_of_curved(const PlacedRound& a, const PlacedRound& b, Cost& cost);

}  // namespace sunder::solid
