// What proves what a line, a ray or a segment and a placed convex polyhedron have in common (docs/claims.md, "pair"):
// that they are apart, meet, touch or overlap, by directions and points as exact numbers.
// For the questions themselves see polyhedron_line.h, polyhedron_ray.h and polyhedron_segment.h, which are asked here.
//
// None throws, but for want of memory.
#pragma once

#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/line/polyhedron_line_support.h>
#include <sunder/solid/object/line.h>

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

namespace sunder::solid {

// In the world.
using LineLike = std::variant<Line, Ray, Segment>;

// By polyhedron_line, polyhedron_ray or polyhedron_segment.
PolyhedronCut polyhedron_line_like(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other);

// Do they touch, or overlap? Relative interiors count: that of a segment is without its ends, that of a ray without its
// beginning; a point is its own. Requires their answer.
Relation contact_of(const ConvexPolyhedron& body, const LineLike& other, const PolyhedronCut& cut);

// The other as a body of a certificate file, so that what is said of it is said of the whole: for
// PairClaims::add_body. A line is a point and two opposite ways, a ray a point and one, a segment its two points.
struct LineBody {
  std::vector<Point3> points;
  std::vector<Way3> ways;
};
LineBody body_of(const LineLike& other);

// A direction along which the polyhedron ends before the other begins; a point that both have, and how each makes it, the
// other as body_of lists it. Require the answer of polyhedron_line_like, that they are apart, and that they meet.
std::array<Dyadic, 3> parting_direction(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other,
                                        const PolyhedronCut& cut);
CommonPoint common_point_of(const ConvexPolyhedron& body, const Pose& pose, const LineLike& other,
                            const PolyhedronCut& cut);

// States whether body a, the polyhedron, and body b, the other, meet; if tells_contact, also whether they touch, or
// overlap; and of those that meet the common part. Requires the answer of polyhedron_line_like. Cost: exact arithmetic
// on a few vertices, and O(log n) probes.
void add_claims(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolyhedron& body, const Pose& pose,
                const LineLike& other, const PolyhedronCut& cut, bool tells_contact);

// States what body a, the polyhedron, and body b, the other, have in common, if that is no point itself. Requires that
// they meet, and their answer. Cost: likewise.
void add_common_part(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolyhedron& body,
                     const Pose& pose, const LineLike& other, const PolyhedronCut& cut);

// States which planes through body b, the line, support body a, the polyhedron. Requires the answer of a method but the
// scan's. Cost: exact arithmetic on a few vertices, and the vertices that are named.
void add_support(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolyhedron& body, const Pose& pose,
                 const Line& line, const LineSupport& support);

}  // namespace sunder::solid
