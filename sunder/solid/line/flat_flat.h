// What have two of points, segments, rays, lines and planes of space in common; do they touch, or overlap; and what
// proves it (docs/claims.md, "pair")? For those of known kinds see line_line.h, plane_line.h and plane_plane.h, which
// are asked here.
//
// None throws, but for want of memory.
#pragma once

#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/line/flat_body.h>
#include <sunder/solid/line/line_line.h>

#include <array>
#include <cstdint>
#include <optional>

namespace sunder::solid {

// What the two have in common, by the function of their kinds. Exact; of the world. Cost: at most 13 signs.
FlatCommon flat_flat(const Flat& a, const Flat& b);

// A point of both, exactly; of both relative interiors, where these meet. Requires their answer, that they meet.
ExactPoint3 common_point(const Flat& a, const Flat& b, const FlatCommon& common);

// A direction along which no point of A is further than any of B: apart, strictly; touching, not all are as far.
// Requires their answer, that they are apart or touch.
std::array<Dyadic, 3> parting(const Flat& a, const Flat& b, const FlatCommon& common);

// What two have in common, where that is a point or a segment: the whole of it is between two points, at which one of
// them ends across the direction, and against it.
struct FlatPart {
  ExactPoint3 first, last;
  Exact3 across;         // from the first end on
  bool along_a = false;  // it is part of a line that A is on; else of one that B is on
};

// Nothing where they have more in common, or none of them is more than a point and on a line. Requires their answer.
std::optional<FlatPart> common_part(const Flat& a, const Flat& b, const FlatCommon& common);

// States what body a and body b of the file have in common.
void add_common_part(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const Flat& a,
                     const FlatBody& body_a, const Flat& b, const FlatBody& body_b, const FlatPart& part);

// States whether body a and body b of the file meet; if tells_contact, also whether they touch, or overlap. Requires
// their answer.
void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const Flat& a, const FlatBody& body_a,
                const Flat& b, const FlatBody& body_b, const FlatCommon& common, bool tells_contact);

}  // namespace sunder::solid
