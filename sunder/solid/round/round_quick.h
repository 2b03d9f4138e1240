// What closed forms and small searches in doubles propose of two bodies with a radius, and what floating point with an
// error bound makes of it: nearly every pair is decided here, without an exact number. For the sources of solid/round.
#pragma once

#include <sunder/solid/round/round_round.h>

namespace sunder::solid {

// True: decided, surely, and the answer's evidence is filled in. Else nothing is said, but for `way`: a direction from
// A to B to begin a search with, or zero. Requires that not both are polyhedra; poses as PlacedRound::pose.
bool decide_quickly(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, RoundAnswer& answer,
                    Point3& way);

}  // namespace sunder::solid
