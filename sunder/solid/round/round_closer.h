// Are two placed bodies, with a radius or without, nearer to each other than that, and if so, how far apart are they?
// Also called: proximity query with a cutoff. For both questions alone: round_clearance.h, round_distance.h.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_distance.h>

#include <variant>

namespace sunder::solid {

// They are nearer, and so far apart.
struct Nearer {
  static constexpr Verdict verdict = Verdict::meet;
  RoundDistanceEvidence distance;
};

// It is undecided whether they are (round_clearance.h, C2).
struct PerhapsNearer {
  static constexpr Verdict verdict = Verdict::undecided;
  RoundDistanceEvidence distance;
};

// Else, of two polyhedra, their closest features; of others a direction along which they are that far apart.
using RoundCloser = Answer<std::variant<PerhapsNearer, Nearer, ClosestFeatures, ClearanceKept>>;

// The verdict is that of round_clearance. Requires a finite positive `least`. Throws Error: bad_pose (round_body.h).
// Cost: of two polyhedra that of polyhedron_polyhedron_distance; of others that of round_clearance, and where they are
// nearer that of round_distance besides.
RoundCloser round_closer(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, double least);

// From A to B, rounded: along it they are about as far apart as asked for, or further. Requires the verdict `apart`.
// Cost: half of that of the distance, mostly in intervals.
Point3 rounded_way(const RoundCloser& apart);

}  // namespace sunder::solid
