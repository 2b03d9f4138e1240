// How far apart are two placed bodies, each with a radius or without?
// Also called: separation distance of primitives; minimum distance; proximity query.
//
//   For any two placed parts:
//     PlacedRound a(body_a, pose_a), b(body_b, pose_b);      // round_body.h; a polyhedron converts to a RoundBody
//     round_distance(a, b).distance                          // low <= the distance <= high, both proved
//     round_clearance(a, b, least).kept()                    // round_clearance.h: at least so far apart? exact
//   Both have add_claims, which write their proofs.
//
//   D1. low <= the distance <= high, exactly: along a direction they are `low` apart, and two points, one of each, are
//       nearer than the next double above `high`.
//   D2. Of two hulls of any radii they are both ends where a double is the distance, else one unit in the last place is
//       between them.
//   D3. Of curved bodies they are some units in the last place apart, but not always: the distance of curved bodies is
//       a root of a polynomial of high degree, and is searched for, in double-doubles. high - low <= 2^-40 of the size
//       of the pair is what tests demand.
//   D4. {0, 0} is said only of what meets, and always where round_round says so. Where that is undecided low is 0.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/number/interval.h>
#include <sunder/solid/round/round_clearance.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace sunder::solid {

struct [[nodiscard]] RoundDistance {
  // Infinity, and the largest double, where it is beyond the range.
  Interval distance;
  std::optional<WorldDirection> direction{};               // low > 0: from A to B, along which they are so far apart
  std::shared_ptr<const std::array<PointOf, 2>> points{};  // of A and of B
  Cost cost;

  bool meet() const { return distance.high == 0; }
};

// Asks first whether they meet. Throws Error: bad_pose. Cost: that of round_round, and again at most 100 steps of
// search in each precision, and some hundred exact numbers; of two hulls that of polyhedron_polyhedron_distance.
RoundDistance round_distance(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b);
RoundDistance round_distance(const PlacedRound& a, const PlacedRound& b);

// States it of two bodies of a certificate file, as two clearances: kept is `low`; broken is `high` where the points
// are nearer than that, else the next double. One of them is left out where low is 0, or high is not finite.
void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const RoundDistance& distance);

}  // namespace sunder::solid
