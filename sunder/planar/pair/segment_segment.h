// How do two closed segments meet? Exact, for every finite double.
// Also called: segment intersection test.
//
// This is the one place where the kinds of contact are told apart; every question about sets of segments asks here.
// Requires finite coordinates. None throws, but for want of memory.
#pragma once

#include <sunder/planar/object/segments.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/posed.h>

#include <cstdint>
#include <string_view>

namespace sunder::planar {

enum class ContactKind : std::uint8_t {
  none,
  shared_endpoint,  // one common point, an end of both
  touch,            // one common point, an end of one and not of the other (which a segment of length zero touches too)
  crossing,         // one common point, an end of neither
  overlap,          // a common part of positive length
};

std::string_view name_of(ContactKind);  // "shared-endpoint"

// How the two meet; the same with s and t exchanged. Requires members of Segments (a lexicographically not after b), as
// all here. Cost: up to four orientations.
ContactKind segment_segment(const Segment& s, const Segment& t, StageTally* tally = nullptr);

// A common point of two segments that meet, which is required: of an overlap, its lexicographically first end. Cost:
// exact arithmetic.
ExactPoint2 common_point(const Segment& s, const Segment& t);

// The same in doubles: each coordinate is the nearest one, ties to even.
Point2 common_point_rounded(const Segment& s, const Segment& t);

}  // namespace sunder::planar
