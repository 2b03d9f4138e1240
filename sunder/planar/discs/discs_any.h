// Do any two of N circles with their insides, closed discs, meet?
// Also called: disk or circle intersection detection.
//
// Nested discs meet. The answer is exactly right for the doubles given: touching, equal, repeated, points.
//   P1. meet() is true iff some two discs, not of one group, have a contact whose kind counts under the rule.
//   P2. The contact named counts; it need not be the leftmost, nor the same for all methods.
//   P3. The answer does not depend on the compiler.
// Throws Error bad_call where there are groups, and not one for each disc. Else none throws, but for want of
// memory, or what `progress` throws.
// Source: Shamos & Hoey 1976, section IV, Theorem 8: N log N is enough, and needed.
// What proves each answer is made by its writer, whatever the method (discs_any_claims.h).
//
// Why it is enough that the sweep tests neighbours. A vertical line that cuts a disc cuts it in an interval around the
// centre's ordinate, and the list is sorted by these ordinates; at one abscissa all first ends come before all last
// ends. Let C stand between A and B in it: y_A <= y_C <= y_B.
//   Where nothing is allowed: let A and B have a common point, at the abscissa t. When the first ends at t are over and
//   its last ends still to come, the list is of all discs whose closed range holds t. The intervals of A and B on the
//   line at t have a common point, so their union holds y_C: C meets A or B there. Replace the other one of the two by
//   C, and so on, until two neighbours in the list meet.
//   Where touching is allowed: let the insides of A and B meet. Then they do so at some t that is the abscissa of no
//   event, where the list is of all discs whose open range holds t, and the same holds of open intervals. A point A
//   inside B: when it has been put in, the list holds B, and others have at least a point at t. The open interval of B
//   holds y_A, so y_C: C has a point inside B; replace A by C, and so on.
// Departure from the paper, which orders the circles on the line by "above": that is the order of their centres, so
// nothing is computed to find it, and no contact disturbs it.
#pragma once

#include <sunder/base/error.h>
#include <sunder/near/set_question.h>
#include <sunder/planar/object/discs.h>
#include <sunder/planar/pair/disc_disc.h>

#include <cstdint>

namespace sunder::planar {

// Allowed::nothing: every contact counts; shared_endpoint and touch: touching does not.
inline bool counts(DiscContact kind, Allowed allowed) {
  return kind != DiscContact::none && (kind != DiscContact::touching || allowed == Allowed::nothing);
}

using DiscsContact = ContactOfTwo<DiscContact>;
using DiscsAnswer = AnyAnswer<DiscsContact>;  // probes: pairs of discs that were compared

// How the discs i and j meet, as disc_disc. Requires i and j below discs.size().
inline DiscContact contact_kind(const Discs& discs, std::uint32_t i, std::uint32_t j) {
  return disc_disc(discs[i], discs[j]);
}

// The front door: the fastest method measured, by grid. Cost: O(N log N) at most; about linear where discs are small.
// With groups: O(N log N + k) for k pairs of boxes that meet and are not of one group.
DiscsAnswer discs_any(const Discs& circles, const SetOptions& options = {});

// Algorithm 1 with discs as units: discs are tested when they become neighbours on the line.
// Cost: at most 3 N pairs, two sorts of N and 2 N numbers, 3 N searches in a RankSet; O(N) memory.
// Where there are groups, whose members may meet, neighbours prove nothing: pairs of different groups whose boxes meet
// are looked at until one counts (discs_all_by_sweep).
DiscsAnswer discs_any_by_sweep(const Discs& circles, const SetOptions& options = {});

// A uniform grid over the discs' boxes finds the pairs that are near each other. Where boxes are large against the
// grid, the sweep decides instead, and where too many crowd in a cell, the sweep decides about these; so its bound
// holds.
DiscsAnswer discs_any_by_grid(const Discs& circles, const SetOptions& options = {});

// Every pair: the oracle. Names the first pair. O(N^2) time.
DiscsAnswer discs_any_by_scan(const Discs& circles, const SetOptions& options = {});

}  // namespace sunder::planar
