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
#include <variant>

namespace sunder::solid {

// Two polyhedra are apart at all times: the direction parts them, and the extreme vertices are so at all times. A
// direction that is named by features is that of the poses at time 0, or at time 1.
struct SeparationOnTheWay {
  static constexpr Verdict verdict = Verdict::apart;
  Separation separation;
  bool is_at_end = false;
};

// Two other bodies are apart at all times: the direction, from A to B, separates them.
struct PartedOnTheWay {
  static constexpr Verdict verdict = Verdict::apart;
  std::array<Dyadic, 3> direction;
};

// Two polyhedra meet at time 0, or at time 1.
struct CommonVerticesAtAnEnd {
  static constexpr Verdict verdict = Verdict::meet;
  CommonVertices common;
  bool is_at_end = false;
};

// They meet at some time; its own direction is zero.
struct ContactOnTheWay {
  static constexpr Verdict verdict = Verdict::meet;
  std::shared_ptr<const SweepContact> contact;
};

// It is not known whether they meet on the way: never of polyhedra.
struct UndecidedOnTheWay {
  static constexpr Verdict verdict = Verdict::undecided;
};

using SweepAnswer =
    Answer<std::variant<UndecidedOnTheWay, SeparationOnTheWay, PartedOnTheWay, CommonVerticesAtAnEnd, ContactOnTheWay>>;

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
