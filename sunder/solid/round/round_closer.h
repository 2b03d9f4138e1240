// Are two placed hulls with a radius (balls, capsules, rounded polyhedra, polyhedra) closer to each other than a
// distance? The yes or no alone, in about the time of "do they meet?".
// Also called: safety margin; distance query with a threshold.
#pragma once

#include <sunder/base/error.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_round.h>

namespace sunder::solid {

struct [[nodiscard]] RoundCloser {
  bool is_closer = false;  // exactly so far apart is not closer
  // What decided, where it was found quickly: of A with a radius that is larger by the distance, and B. Undecided: the
  // exact distance of the cores did.
  RoundAnswer answer;
};

// Exact. The same answer as round_clearance (round_clearance.h), which makes the numbers of a certificate. Requires
// hulls, and a finite positive `least`. Throws Error: bad_pose (round_body.h). Cost: that of round_round; where the
// distance is `least` to some 2^-50 of the size of the bodies, that of polyhedron_polyhedron_distance.
RoundCloser round_closer(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, double least);

}  // namespace sunder::solid
