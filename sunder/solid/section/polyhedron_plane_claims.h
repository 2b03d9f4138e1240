// What proves how a placed convex polyhedron and a plane lie (docs/claims.md, "pair"): statements for certificate
// files. For the question itself see polyhedron_plane.h.
//
// The plane is one body of the file, of a point and of ways that span it (flat_body.h). Apart, and touching: its normal
// parts them. They meet: on the edge, or chord, between a vertex that is not above the plane and one that is not below
// it, there is a point of the plane. They overlap: one that is inside of the body besides.
#pragma once

#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/line/flat_body.h>
#include <sunder/solid/section/polyhedron_plane.h>

#include <cstdint>

namespace sunder::solid {

// A point of both that the answer names: a vertex, or on the way from `below` to `above`. Requires that they meet.
ExactPoint3 common_point(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane,
                         const PolyhedronPlane& answer);

// States whether body a of the file, the polyhedron, and body b, the plane, meet; where the contact is not none,
// whether they touch, or overlap; where they are apart, the nearest vertex. Requires their answer and contact, and the
// plane's body. Throws nothing, but for want of memory. Cost: exact arithmetic on a few vertices; where `below` or
// `above` is on the plane, until one is found that is not.
void add_claims(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolyhedron& body, const Pose& pose,
                const Plane& plane, const FlatBody& in_file, const PolyhedronPlane& answer, Relation contact);

}  // namespace sunder::solid
