// A ball and a ball, a box or a cylinder, in closed form: the first of what is quick (round_quick.h). For the sources
// of solid/round.
#pragma once

#include <sunder/solid/round/round_pieces.h>

namespace sunder::solid::round_quick {

inline bool is_ball(const RoundBody& body) { return !body.is_curved() && body.ends().size() == 1; }

// True: decided, surely, and the answer's evidence is filled in. `way`: from A to B, about, or as it was.

// Requires two balls.
bool balls(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, RoundAnswer& answer,
           Point3& way);

// Requires that one of them is a ball. Of others than boxes and cylinders nothing is said.
bool ball_and(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, RoundAnswer& answer,
              Point3& way);

// The direction parts A from B, surely.
bool parts(const V& direction, const RoundImage& a, const RoundImage& b, RoundAnswer& answer, Point3& way);

}  // namespace sunder::solid::round_quick
