// Are two placed hulls with a radius (balls, capsules, rounded polyhedra, polyhedra) so far apart, or further? Exact.
// Also called: safety margin; distance query with a threshold.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/round/round_body.h>

#include <array>
#include <cstdint>

namespace sunder::solid {

struct [[nodiscard]] RoundClearance {
  bool kept = false;                  // at least so far apart; exactly so far is kept
  std::array<Dyadic, 3> direction{};  // kept: from A to B, along which they are
  PointOf of_a, of_b;                 // not kept: points of both that are nearer to each other than that
  Interval distance;                  // about: between these; zero where they meet
};

// The distance of the cores against the sum of the radii and `least`, exactly. Requires hulls, and a finite positive
// `least`. Throws Error: bad_pose (round_body.h). Cost: that of polyhedron_polyhedron_distance.
RoundClearance round_clearance(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                               double least);
RoundClearance round_clearance(const PlacedRound& a, const PlacedRound& b, double least);

// States it of two bodies of a certificate file.
void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, double least,
                const RoundClearance& clearance);

}  // namespace sunder::solid
