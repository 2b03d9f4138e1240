// sunder region --of circles: what is the common part of circles, with their insides?
#pragma once

#include <sunder/ask/region/region_call.h>

namespace sunder::ask {

// Prints the answer; returns the exit code. Throws Error for bad input.
int run_region_circles(const RegionCall& call);

}  // namespace sunder::ask
