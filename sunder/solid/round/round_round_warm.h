// Do two placed bodies meet? Two polyhedra are asked about by a method of the caller's, or from the last answer on.
// Also called: warm start. The question itself: round_round.h.
#pragma once

#include <sunder/base/error.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>
#include <sunder/solid/round/round_round.h>

namespace sunder::solid {

using PolyhedronMethod = PairAnswer (*)(const ConvexPolyhedron&, const Pose&, const ConvexPolyhedron&, const Pose&);

// Two polyhedra by the method; others as round_round.
RoundAnswer round_round_by(PolyhedronMethod method, const RoundBody& a, const Pose& pose_a,  //
                           const RoundBody& b, const Pose& pose_b);

// Two polyhedra as polyhedron_polyhedron_warm; others as round_round: of these `last` stays as it is.
RoundAnswer round_round_warm(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                             WarmStart& last);

}  // namespace sunder::solid
