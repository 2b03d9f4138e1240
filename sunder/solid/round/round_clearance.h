// Are two placed bodies, with a radius or without, so far apart, or further? Exact.
// Also called: safety margin; distance query with a threshold. How far apart they are: round_distance.h.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/round/round_body.h>

#include <array>
#include <cstdint>
#include <memory>
#include <variant>

namespace sunder::solid {

// Kept: so far apart, or further; exactly so far is kept. Along this direction, from A to B.
struct ClearanceKept {
  static constexpr Verdict verdict = Verdict::apart;
  WorldDirection direction;
};

// Broken: points of A and of B that are nearer to each other than that.
struct ClearanceBroken {
  static constexpr Verdict verdict = Verdict::meet;
  std::shared_ptr<const std::array<PointOf, 2>> points;  // not null
};

// The distance is within some 2^-40 of their size of it.
struct ClearanceUndecided {
  static constexpr Verdict verdict = Verdict::undecided;
};

using RoundClearance = Answer<std::variant<ClearanceUndecided, ClearanceKept, ClearanceBroken>>;

// `apart` is kept, and `meet` broken, as bodies would meet that are wider by that.
inline bool is_kept(const RoundClearance& found) { return found.verdict() == Verdict::apart; }
inline bool is_broken(const RoundClearance& found) { return found.meet(); }

//   C1. kept and broken are exactly right for the doubles given, and come with evidence that exact arithmetic has
//       checked: a direction d with g - sqrt(u) - sqrt(v) >= least |d| (predicate/disc/round_shape.h), or two points.
//   C2. Decided always: two hulls, of any radii. Where a body is curved: where the distance differs from `least` by
//       more than some 2^-40 of their size, and mostly nearer. Of discs as good as flat, cylinders and cones whose
//       radius is more than 2^30 times their height, that grows: at 2^45 times it is some 2^-12.
//   C3. Never undecided where round_distance's enclosure tells: kept where `least` is at most its `low`, broken where
//       it is above its `high`.
// Requires a finite positive `least`. Throws Error: bad_pose (round_body.h). Cost: that of round_round
// (round_round.h), and of two hulls no more than that of polyhedron_polyhedron_distance besides.
RoundClearance round_clearance(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                               double least);
RoundClearance round_clearance(const PlacedRound& a, const PlacedRound& b, double least);

// The verdict alone, for a half to a tenth of the cost, because exact points are not made. What is decided by both is
// decided alike. Requires and throws as round_clearance.
Verdict clearance_verdict(const PlacedRound& a, const PlacedRound& b, double least);

// States it of two bodies of a certificate file. Requires that it is decided.
void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, double least,
                const RoundClearance& clearance);

}  // namespace sunder::solid
