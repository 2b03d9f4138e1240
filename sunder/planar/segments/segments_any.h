// Do any two of N closed segments meet?
// Also called: segment intersection detection.
//
// The answer is exactly right for the doubles given, whatever the position: vertical, horizontal, collinear,
// overlapping, zero-length, repeated segments, many through one point. Its evidence: two segments that meet in a way that
// counts; that there are none is proved by the events of a sweep (certificate format: docs/claims.md).
//   P1. meet() is true iff some two segments, not of one group, have a contact whose kind counts.
//   P2. The contact named counts; it need not be the leftmost, nor the same for all methods.
//   P3. The answer does not depend on the compiler.
// Throws Error bad_call where there are groups, and not one for each segment; else none throws, but for want of memory,
// or what `progress` throws. Source: Shamos & Hoey 1976, section III, Algorithm 1 and Theorems 2 and 3.
#pragma once

#include <sunder/base/error.h>
#include <sunder/near/set_question.h>
#include <sunder/planar/object/segments.h>
#include <sunder/planar/pair/segment_segment.h>
#include <sunder/planar/segments/contact_rule.h>
#include <sunder/planar/sweep/sweep_events.h>

#include <cstdint>
#include <span>

namespace sunder::planar {

using SegmentsContact = ContactOfTwo<ContactKind>;

using SegmentsAnswer = AnyAnswer<SegmentsContact>;  // probes: pairs of segments that were compared

// How the segments i and j meet, as segment_segment. Requires i and j below segments.size().
inline ContactKind contact_kind(const Segments& segments, std::uint32_t i, std::uint32_t j) {
  return segment_segment(segments[i], segments[j]);
}

// The front door: the fastest method measured, by grid. Cost: O(N log N) at most, whatever the position; about linear
// where segments are short. With groups: that of the sweep that passes crossings at most, but for a constant; O(N log N)
// where few boxes of different groups meet (segments_all.h).
SegmentsAnswer segments_any(const Segments& segments, const SetOptions& options = {});

// Algorithm 1: a line sweeps over the plane; segments are tested when they become neighbours on it.
// Cost: O(N log N) comparisons; O(N) memory. Where there are groups, whose members may cross: as segments_all_by_sweep
// (segments_all.h) up to the first contact that counts.
SegmentsAnswer segments_any_by_sweep(const Segments& segments, const SetOptions& options = {});

// The same where the order of the ends (as by ends_in_order) is known. Requires that there are no groups.
SegmentsAnswer segments_any_by_sweep_over(const Segments& segments, std::span<const std::uint32_t> ends,
                                          const SetOptions& options = {});

// The sweep that passes crossings, up to the first contact that counts.
// Cost: O((N + k) log N) comparisons for k contacts that do not count; O(N + k) memory.
SegmentsAnswer segments_any_by_bentley_ottmann(const Segments& segments, const SetOptions& options = {});

// The same, with its transcript, which proves that none meet; empty where some do.
SegmentsAnswer segments_any_with_transcript(const Segments& segments, const SetOptions& options,
                                            SweepEvents& transcript);

// A uniform grid over the segments' boxes finds the pairs that are near each other. Where boxes are long against the
// grid, the sweep decides instead, and where too many crowd in a cell, the sweep decides about these; so its bound
// holds.
SegmentsAnswer segments_any_by_grid(const Segments& segments, const SetOptions& options = {});

// Every pair: the oracle. Names the first pair. O(N^2) time.
SegmentsAnswer segments_any_by_scan(const Segments& segments, const SetOptions& options = {});

}  // namespace sunder::planar
