// Do the boundaries (surfaces) of two placed convex polyhedra meet, or is one of them inside the other?
// Also called: surface intersection detection; containment test.
//
// The boundary of a flat polygon, a segment or a point is all of it. Exactly right for the doubles given; touching is
// meeting. A pose maps its body's frame to the world.
// Source: Chazelle & Dobkin 1987, Theorem 5, of polygons; the same holds of polyhedra: each facet of a body around
// another one may be the only one that is not far enough out. So this question is linear, and its methods are no match
// for those that ask whether the bodies meet.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

namespace sunder::solid {

// Cost: that of polyhedron_polyhedron where they are apart; else O(n log m + m log n) probes more at most, and an exact
// direction for each facet. Allocates.
RelationAnswer polyhedron_polyhedron_boundary(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                              const ConvexPolyhedron& b, const Pose& pose_b);

// Every vertex against every facet, in exact numbers: the oracle. O(n m).
RelationAnswer polyhedron_polyhedron_boundary_by_scan(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                                      const ConvexPolyhedron& b, const Pose& pose_b);

}  // namespace sunder::solid
