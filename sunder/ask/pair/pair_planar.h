// sunder pair where A and B are planar: points, segments, convex polygons out of WKT, GeoJSON and CSV.
#pragma once

#include <sunder/ask/pair/pair_question.h>

namespace sunder::ask {

// What poses may be, for help texts.
extern const char* const planar_pose_forms;

// Answers; returns the exit code. Throws Error for bad input.
int run_planar_pair(const PairCall& call);

}  // namespace sunder::ask
