// Do any two of N closed intervals on a line meet?
// Also called: interval overlap detection.
//
//   P1. meet() is true iff some two have a contact whose kind counts: shared_endpoint (one common point, an end of
//       both), touch (an interval of length zero inside of another), overlap (a common part of positive length).
//   P2. Where none meet, intervals_in_order proves it: each interval ends before the next begins, or, where shared ends
//       are allowed, where the next begins. (Where touches are allowed: once those of length zero are left out.)
// Source: Shamos & Hoey 1976, section II: sorting is enough, and no fewer comparisons than N log N do.
#pragma once

#include <sunder/base/error.h>
#include <sunder/near/set_question.h>
#include <sunder/planar/segments/contact_rule.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

struct LineInterval {
  double low = 0, high = 0;
};

using IntervalsAnswer = AnyAnswer<ContactOfTwo<ContactKind>>;  // probes: comparisons of intervals

// Throws Error bad_value, "interval 7: ...", where an end is not finite or low > high; bad_shape for 2^31 or more.
// Cost: O(N log N) comparisons, O(N) memory.
IntervalsAnswer intervals_any(std::span<const LineInterval> intervals, Allowed allowed = Allowed::nothing);

// The intervals from left to right: by their low ends, then by their high ends. Throws and costs as above.
std::vector<std::uint32_t> intervals_in_order(std::span<const LineInterval> intervals);

// Every pair: the oracle.
IntervalsAnswer intervals_any_by_scan(std::span<const LineInterval> intervals, Allowed allowed = Allowed::nothing);

}  // namespace sunder::planar
