// sunder region --of polygons: what is the common part of convex polygons?
#pragma once

#include <sunder/ask/region/region_call.h>

namespace sunder::ask {

// Prints the answer; returns the exit code. Throws Error for bad input, also where a polygon is not convex.
int run_region_polygons(const RegionCall& call);

}  // namespace sunder::ask
