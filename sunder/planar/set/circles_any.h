// Do any two of N circles with their insides, closed discs, meet?
//
// Nested discs meet. The answer is exactly right for the doubles given: touching, equal, repeated, points. It comes
// with its evidence: two discs that meet in a way that counts, or a transcript of a sweep that proves that there are
// none.
//   P1. meet() is true iff some two discs, not of one group, have a contact whose kind counts under the rule.
//   P2. The contact named counts; it need not be the leftmost, nor the same for all methods.
//   P3. The answer does not depend on the compiler.
// Source: Shamos & Hoey 1976, section IV, Theorem 8: N log N is enough, and needed.
//
// The evidence, for checkers. Disc i has the centre (x_i, y_i) and the radius r_i >= 0. All numbers are exact.
//   some: two numbers i < j, a kind, and a point (p, q), given as fractions.
//     C1. The kind counts, and where there are groups, i and j are not of one.
//     C2. (p - x)^2 + (q - y)^2 <= r^2 for both discs.
//     C3. The kind is that of the contact. With D = (x_i - x_j)^2 + (y_i - y_j)^2: touching: D = (r_i + r_j)^2;
//         overlapping: (r_i - r_j)^2 < D < (r_i + r_j)^2; inside: D < (r_i + r_j)^2 and D <= (r_i - r_j)^2.
//   none, without groups: the events 2 i, the first end of disc i, at the abscissa x_i - r_i, and 2 i + 1, its last
//   end, at x_i + r_i; and for each first end, in the order of the events, `below`: a disc, or none.
//     T1. The events are each end of each disc once. The abscissas, exact sums, never decrease; at equal abscissas all
//         first ends come before all last ends. (So a first end comes before its last end.)
//     T2. Keep a list, empty at first. At a first end of i the disc is put into the list just after `below` (none: at
//         its beginning), which must be in it; at a last end it is taken out.
//     T3. Put in at i, between the disc b below and the one a that is now after it, where there are such:
//         y_b <= y_i <= y_a.
//     T4. Two discs i and j that become neighbours (b and i, i and a; and where one is taken out, the two around it):
//         D > (r_i + r_j)^2, or, where touching is allowed, D >= (r_i + r_j)^2.
// Why T1 to T4 prove it. A vertical line that cuts a disc cuts it in an interval around the centre's ordinate. By T2
// and T3 the list is sorted by these ordinates, so let C stand between A and B in it: y_A <= y_C <= y_B.
//   Where nothing is allowed: let A and B have a common point, at the abscissa t. When the first ends at t are over and
//   its last ends still to come, by T1 the list is of all discs whose closed range holds t. The intervals of A and B on
//   the line at t have a common point, so their union holds y_C: C meets A or B there. Replace the other one of the two
//   by C, and so on, until two neighbours in the list meet; against T4.
//   Where touching is allowed: let the insides of A and B meet. Then they do so at some t that is the abscissa of no
//   event, where the list is of all discs whose open range holds t, and the same holds of open intervals. A point A
//   inside B: when it has been put in, the list holds B, and others have at least a point at t. The open interval of B
//   holds y_A, so y_C: C has a point inside B; replace A by C, and so on.
// Departure from the paper, which orders the circles on the line by "above": that is the order of their centres, so
// nothing is computed to find it, and no contact disturbs it.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/planar/object/circle.h>
#include <sunder/planar/pair/circle_circle.h>
#include <sunder/planar/set/contact_rule.h>
#include <sunder/planar/set/segments_any.h>
#include <sunder/planar/set/sweep_transcript.h>

#include <cstdint>
#include <functional>

namespace sunder::planar {

// Allowed::nothing: every contact counts; shared_endpoint and touch: touching does not.
inline bool counts(DiscContact kind, Allowed allowed) {
  return kind != DiscContact::none && (kind != DiscContact::touching || allowed == Allowed::nothing);
}

struct CirclesAnswer {
  DiscContact kind = DiscContact::none;  // of the contact; none: no two discs meet in a way that counts
  std::uint32_t i = 0, j = 0;            // the two discs, i < j; meaningless for `none`
  SweepTranscript transcript;            // events and below; empty unless asked for, for `none`, without groups
  Cost cost;                             // probes: pairs of discs that were compared

  bool meet() const { return kind != DiscContact::none; }
};

struct CirclesOptions {
  Allowed allowed = Allowed::nothing;
  bool transcript = false;
  Groups groups{};                                 // members of one group may meet
  std::function<void(double)> progress = nullptr;  // called now and then with the part that is done, 0 to 1
};

// The front door: the fastest method measured.
CirclesAnswer circles_any(const Circles& circles, const CirclesOptions& options = {});

// Algorithm 1 with discs as units: discs are tested when they become neighbours on the line.
// Cost: at most 3 N pairs, two sorts of N and 2 N numbers, 3 N searches in a RankSet; O(N) memory.
// Where there are groups, whose members may meet, neighbours prove nothing: all pairs whose boxes meet are looked at
// from left to right until one counts (visit_circle_contacts_by_sweep), and there is no transcript.
CirclesAnswer circles_any_by_sweep(const Circles& circles, const CirclesOptions& options = {});

// A uniform grid over the discs' boxes finds the pairs that are near each other. Where boxes are large against the
// grid, or a transcript is asked for, the sweep decides instead, and where too many crowd in a cell, the sweep decides
// about these; so its bound holds.
CirclesAnswer circles_any_by_grid(const Circles& circles, const CirclesOptions& options = {});

// Every pair: the oracle. Names the first pair. Writes no transcript. O(N^2) time.
CirclesAnswer circles_any_by_scan(const Circles& circles, const CirclesOptions& options = {});

}  // namespace sunder::planar
