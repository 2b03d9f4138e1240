// Do two placed bodies with a radius that meet touch, or overlap?
// Also called: contact; penetration; interiors.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/round/round_round.h>

#include <array>
#include <variant>

namespace sunder::solid {

// Of the relative interiors, as for polyhedra; a body with a radius above 0 has an inside.
//   C1. Nothing is said that is not proved: what overlaps comes with a point inside of both, what touches with a common
//       point and a direction that parts them weakly.
//   C2. Decided always: two hulls, of any radii; a cylinder or an ellipsoid against a polyhedron of radius 0.
struct NoContact {  // they are apart, or it is undecided
  static constexpr Relation relation = Relation::none;
};
struct TouchingAt {
  static constexpr Relation relation = Relation::touching;
  CommonPoint point;
  std::array<Dyadic, 3> direction;  // from A to B
};
struct OverlappingAt {
  static constexpr Relation relation = Relation::overlapping;
  CommonPoint point;  // inside of both
};
using RoundContact = std::variant<NoContact, TouchingAt, OverlappingAt>;

// Asks first whether they meet; that answer may be given. Cost: that of round_round, and as much again. Throws Error as
// round_round.
RoundContact round_round_contact(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b);
RoundContact round_round_contact(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence);

// The same without the evidence, which of polyhedra costs more than the answer.
Relation round_round_relation(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence);

}  // namespace sunder::solid
