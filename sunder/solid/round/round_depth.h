// How deep are two placed bodies in each other, each with a radius or without?
// Also called: penetration depth of primitives.
//
// The depth is that of polyhedron_polyhedron_depth.h: the least length of a translation of A after which the two do not
// overlap.
//   P1. low <= the depth <= high, exactly, and both are proved: along `direction` A reaches by no more than `high`
//       beyond where B begins; and by a surface around the origin, of differences of points of the cores, or by points
//       of the cores that are no further apart than the radii exceed `low` (depth_claims.h).
//   P2. Of two hulls of any radii they are both ends where a double is the depth, else neighbouring doubles, where the
//       depth of their cores is exact.
//   P3. Of curved bodies high - low is mostly at most round_depth_width times the depth, or 2^-40 of the size of the
//       pair. It is more, up to some 5e-3 of the depth, where the difference ends as soon along very many directions:
//       of an ellipsoid that is nearly a ball, or a cylinder or a cone about the other body, and one centre or axis.
//       low is 0 where the bodies hardly meet, and where the difference is flat, or as thin as 2^-40 of its size.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/depth_claims.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_round.h>

#include <cstdint>
#include <variant>

namespace sunder::solid {

inline constexpr double round_depth_width = 0x1p-22;
inline constexpr std::uint32_t round_depth_most_corners = 1000;

// If the bodies meet, the evidence is their depth; otherwise it is that of round_round.
using RoundDepth =
    Answer<std::variant<NearlyTouching, Separation, SeparatingDirection, ExactSeparatingDirection, EnclosedDepth>>;

// nullptr where they are not known to meet.
inline const EnclosedDepth* depth_of(const RoundDepth& answer) { return std::get_if<EnclosedDepth>(&answer.evidence); }

// Asks first whether they meet. Throws Error: bad_pose. Cost: that of round_round; of two hulls that of
// polyhedron_polyhedron_depth and polyhedron_polyhedron_distance; of others a step of search and some exact numbers a
// corner, of which there are mostly some hundred, and at most round_depth_most_corners.
RoundDepth round_depth(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b);
RoundDepth round_depth(const PlacedRound& a, const PlacedRound& b);

}  // namespace sunder::solid
