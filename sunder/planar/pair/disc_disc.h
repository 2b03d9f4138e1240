// How do two circles with their insides, closed discs, meet? Exact, for every finite double.
// Also called: circle or disk intersection test.
//
// This is the one place where the kinds of contact are told apart; every question about sets of circles asks here.
// With d the distance of the centres, r and s the radii, the first that holds of: d > r + s: none; d = r + s: touching;
// d > |r - s|: overlapping; else inside. No square roots: d^2 is compared with (r + s)^2 and (r - s)^2.
// Requires finite numbers and radii that are not negative, as of members of Discs. None throws, but for want of memory.
#pragma once

#include <sunder/planar/object/discs.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/posed.h>

#include <cstdint>
#include <string_view>

namespace sunder::planar {

enum class DiscContact : std::uint8_t {
  none,
  touching,     // one common point, on both circles, from outside; also a point on a circle, and two equal points
  overlapping,  // the circles cross in two points: some common points, and neither disc holds the other
  inside,       // one holds the other: apart from its circle, touching it from inside, or equal, with radius not zero
};

std::string_view name_of(DiscContact);  // "touching"

// How the two meet; the same with c and d exchanged. Cost: one sign, and one more where they meet in more than a touch.
DiscContact disc_disc(const Disc& c, const Disc& d, StageTally* tally = nullptr);

// A common point of two that meet, which is required, as fractions: of an inside contact the centre of the smaller one
// (of equals: c's); else the point that parts the centres' segment as r to s, which is inside both where they overlap.
// P1. |p - c|^2 <= r^2 and |p - d|^2 <= s^2, exactly; both are equal iff they touch.
ExactPoint2 common_point(const Disc& c, const Disc& d);

// The same in doubles: each coordinate is the nearest one, ties to even.
Point2 common_point_rounded(const Disc& c, const Disc& d);

}  // namespace sunder::planar
