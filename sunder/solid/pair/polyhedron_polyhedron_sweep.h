// Do two convex polyhedra meet at any time, while they move straight from where they are to where they will be?
// Also called: continuous collision detection of translations; linear sweep, convex sweep test, shape cast; time of
// impact.
//
// Time goes from 0 to 1. A body is translated at constant speed from its pose at time 0 to that at time 1, which have
// one linear part: no body turns. The bodies are closed: touching is meeting.
//   S1. The verdict is that of the exact images at all real times, the ends included: the translation at time s is
//       exactly (1 - s) times that at time 0 and s times that at time 1, never rounded.
//   S2. Where both rest, the verdict is polyhedron_polyhedron's. Swapping the bodies, running time backwards, and one
//       exact shift of both at time 0 and another at time 1 do not change it.
//   S3. Bodies are apart all the time iff one direction parts them at both ends: the gap along a fixed direction is
//       linear in time, and those who are apart all the time are so with their relative paths, which are convex.
// What one might assume and does not hold: bodies that are apart at both ends may meet between; and bodies that are
// parted at both ends by two directions need not be apart between.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/exact/sweep_contact.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/translation.h>

#include <array>
#include <memory>
#include <optional>

namespace sunder::solid {

struct [[nodiscard]] SweepAnswer {
  enum class Found : std::uint8_t {
    at_begin,  // evidence is of the poses at time 0
    at_end,    // of those at time 1
    between,   // contact has it; evidence but its verdict is meaningless
  };

  // meet: of the one time. apart: of all times; the direction, where it is named by features, is that of the poses at
  // the one time, and the extreme vertices are so at all times.
  PairCertificate evidence;
  Found found = Found::at_begin;
  std::shared_ptr<const SweepContact> contact{};  // null but for `between`
  DecidedBy decided_by = DecidedBy::filter;
  Cost cost;

  bool meet() const { return evidence.verdict == Verdict::meet; }
};

// Asks at both ends, and tries the directions found there at the other one; then searches in floating point for a
// direction that holds at both; then decides by the exact simplex method.
// Cost: two questions of polyhedron_polyhedron; where these do not decide, at most 100 steps in doubles, each of
// O(log n + log m) probes; where they meet between the ends, or nothing holds, some ten to forty exact pivots.
SweepAnswer polyhedron_polyhedron_sweep(const ConvexPolyhedron& a, const Translation& of_a,  //
                                        const ConvexPolyhedron& b, const Translation& of_b);

// The first time at which they meet; nothing where they never do. Exact: a rational number. Allocates.
// Cost: some ten to forty exact pivots (sweep_simplex.h).
std::optional<SweepContact> polyhedron_polyhedron_first_contact(const ConvexPolyhedron& a, const Translation& of_a,  //
                                                                const ConvexPolyhedron& b, const Translation& of_b);

// The direction along which they are apart all the time, as exact numbers. Requires an answer `apart` about these.
std::array<Dyadic, 3> parting_direction(const SweepAnswer& answer,                           //
                                        const ConvexPolyhedron& a, const Translation& of_a,  //
                                        const ConvexPolyhedron& b, const Translation& of_b);

}  // namespace sunder::solid
