// Which pairs of N closed segments meet, and how many are they?
// Also called: segment intersection reporting and counting; spatial self-join.
//
//   P1. Each pair that has a contact whose kind counts, and whose segments are not of one group, is given once.
//   P2. The pairs given and their kinds do not depend on the method; their order does.
//   P3. The answer does not depend on the compiler.
// k is the number of all contacts, also of those that do not count. Where there are groups, and at most 4 N log2 N
// pairs of boxes of different groups meet, no more than 16 N contacts within groups are in k.
// Throws Error bad_call where there are groups, and not one for each segment; else none throws, but for want of memory,
// or what `progress` or a visitor throws. Sources: Shamos & Hoey 1976, section VI (the question); Bentley & Ottmann
// 1979; Balaban 1995.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/near/contacts_in_order.h>
#include <sunder/planar/object/segments.h>
#include <sunder/planar/segments/segments_any.h>

#include <functional>
#include <limits>
#include <optional>

namespace sunder::planar {

using SegmentsAllAnswer = AllAnswer<SegmentsContact>;  // probes: pairs that were compared, also boxes in a cell

// The front doors: the fastest method measured, by grid. Cost: that of the sweep at most, but for a constant. Counting
// holds no contacts. sweep_events, below, proves the answer.
SegmentsAllAnswer segments_all(const Segments& segments, const SetOptions& options = {});
CountAnswer<> segments_count(const Segments& segments, const SetOptions& options = {});

// Calls for each contact, in the order of the method, until the visitor returns false.
using SegmentsVisitor = std::function<bool(const SegmentsContact&)>;
using SegmentsMethod = Cost(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit);

SegmentsMethod segments_visit;  // the front door

// Those whose i the block holds, for ContactsInOrder: of all segments by the method, of a narrow block by boxes of its
// members, else those of the method that the block holds.
Cost segments_visit_block(const Segments& segments, const SetOptions& options, const Block& block, SegmentsMethod* by,
                          const SegmentsVisitor& visit);

// A grid over the segments' boxes; where it does not pay, or many crowd in a cell, by a sweep.
SegmentsMethod segments_all_by_grid;

// By Balaban where a sample of pairs tells that k is much larger than N, else by Bentley and Ottmann. Where there are
// groups, and k is large, first by the pairs of boxes of different groups that meet (box_pairs.h), if they are few.
SegmentsMethod segments_all_by_sweep;

// The sweep of Bentley and Ottmann: contacts in lexicographic order of their (first) common point.
// O((N + k) log N) comparisons; O(N + k) memory.
SegmentsMethod segments_all_by_bentley_ottmann;

// The same, with its transcript.
Cost segments_visit_with_transcript(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit,
                                    SweepEvents& transcript);

// The events alone: they tell all contacts, and are the same whatever counts. nullopt where they would have more than
// `most` entries. Cost: as above, k all pairs of neighbours that cross.
std::optional<SweepEvents> sweep_events(const Segments& segments,
                                        std::size_t most = std::numeric_limits<std::size_t>::max());

// Balaban's staircases: contacts in no particular order. O(N log N + k) comparisons; O(N) memory.
SegmentsMethod segments_all_by_balaban;

// Every pair: the oracle, by i, then j. O(N^2) time.
SegmentsMethod segments_all_by_scan;

}  // namespace sunder::planar
