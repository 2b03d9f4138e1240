// Do two bodies, with a radius or without, meet at any time, while they go straight from where they are to where they
// will be?
// Also called: continuous collision detection of primitives; swept sphere, shape cast; time of impact.
//
// The question of polyhedron_polyhedron_sweep.h, of all bodies of round_body.h; a polyhedron is one of radius 0. Time
// goes from 0 to 1, and no body turns. An ellipsoid goes straight between the two maps that PlacedRound makes of it.
//   W1. apart and meet are exactly right for the translations at all real times, the ends included; touching is
//       meeting. With each of them comes evidence that exact arithmetic has checked: one direction that parts them at
//       both ends, and so all along (their gap along it is linear in time), or a time and a point of both then.
//   W2. Decided always: two hulls, of any radii.
//   W3. Where a body is curved it may be undecided: where the least gap on the way, or the greatest depth, is below
//       some 2^-40 of the size of the pair and of their ways.
//   W4. The answer and the evidence are the same for every compiler, thread count and vector unit.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/number/interval.h>
#include <sunder/solid/pair/polyhedron_polyhedron_sweep.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_round.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace sunder::solid {

// Asks round_round at both ends, then at times between: a direction that parts them then also parts them at the times
// on one side of it, and of two that leave no time between a mixture parts them all along. Where nothing holds, of two
// hulls the exact nearest points of the cores on their ways. Throws Error: bad_pose (round_body.h). Cost: some two to
// sixty questions of round_round, and of two hulls an exact search of a few steps; of two polyhedra that of
// polyhedron_polyhedron_sweep. Allocates.
SweepAnswer round_round_sweep(const RoundBody& a, const Translation& of_a,  //
                              const RoundBody& b, const Translation& of_b);

// In exact numbers, for certificate files: the direction along which they are apart; the time at which they meet, and
// the point. Require an answer of that verdict about these.
std::array<Dyadic, 3> direction_of(const RoundBody& a, const Translation& of_a,  //
                                   const RoundBody& b, const Translation& of_b, const SweepAnswer& answer);
SweepContact contact_of(const RoundBody& a, const Translation& of_a,  //
                        const RoundBody& b, const Translation& of_b, const SweepAnswer& answer);

// When they first meet: not before time.low, and at `contact`, whose time is time.high or, of a fraction, the nearest
// double below that. Both ends are proved; of polyhedra they are neighbours, of others the first time is a root of a
// polynomial, and they are mostly 2^-40 apart, but more where the bodies come to each other slowly.
struct RoundFirstContact {
  Interval time{0, 0};
  SweepContact contact;  // its direction is set of two polyhedra alone
};

// Requires an answer `meet` about these. Throws Error as round_round_sweep. Cost: likewise.
RoundFirstContact round_round_first_contact(const RoundBody& a, const Translation& of_a,  //
                                            const RoundBody& b, const Translation& of_b,  //
                                            const SweepAnswer& answer);

// States it of two bodies of a certificate file, which are where they begin, and the same where they end (one that
// rests is there already). Requires that it is decided.
struct ClaimedMotion {
  std::uint32_t a, b, to_a, to_b;
};
void add_claims(PairClaims& pairs, const ClaimedMotion& bodies, const RoundBody& a, const Translation& of_a,
                const RoundBody& b, const Translation& of_b, const SweepAnswer& answer);
void add_claims(PairClaims& pairs, const ClaimedMotion& bodies, const RoundFirstContact& first);

}  // namespace sunder::solid
