// What the front doors for two bodies (round_round.cpp) choose from. For the sources of solid/round.
#pragma once

#include <sunder/solid/round/round_closer.h>
#include <sunder/solid/round/round_contact.h>
#include <sunder/solid/round/round_depth.h>
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_round_sweep.h>

namespace sunder::solid {

// Of bodies that are not both polyhedra. Of a contact: they meet.
RoundContact contact_searched(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence);
RoundDistance distance_searched(const PlacedRound& a, const PlacedRound& b);
RoundCloser closer_searched(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                            double least);

// The same of two polyhedra.
RoundCloser closer_of_polyhedra(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                                double least);

// The depth of two bodies that meet. Adds to `cost`.
EnclosedDepth depth_of_meeting(const PlacedRound& a, const PlacedRound& b, Cost& cost);
EnclosedDepth depth_of_hulls(const PlacedRound& a, const PlacedRound& b, Cost& cost);
EnclosedDepth depth_of_curved(const PlacedRound& a, const PlacedRound& b, Cost& cost);  // one of them, or both

// cores_tell: both are hulls, so that the nearest points of their cores decide.
SweepAnswer sweep_searched(const RoundBody& a, const Translation& of_a, const RoundBody& b, const Translation& of_b,
                           bool cores_tell);
RoundFirstContact first_contact_searched(const RoundBody& a, const Translation& of_a, const RoundBody& b,
                                         const Translation& of_b, bool cores_tell, const SweepContact& contact);

}  // namespace sunder::solid
