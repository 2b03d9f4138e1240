// Do the boundaries of two placed convex polygons meet, or is one of them inside the other?
// Also called: boundary intersection detection; containment test.
//
// The boundary of a segment or a point is all of it. Exactly right for the doubles given; touching is meeting.
// None allocates while filters decide, and none throws, but for want of memory.
// Source: Chazelle & Dobkin 1987, Theorem 5: no test by vertices in random access can do with less than linear time,
// as each vertex of a polygon around another one may be the only one that is not far enough out.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

namespace sunder::planar {

// Cost: that of polygon_polygon where they are apart; else at most 4 (n + m) probes more.
RelationAnswer polygon_polygon_boundary(const ConvexPolygon& a, const Pose& pose_a,  //
                                        const ConvexPolygon& b, const Pose& pose_b);

// Every vertex against every edge: the oracle. O(n m).
RelationAnswer polygon_polygon_boundary_by_scan(const ConvexPolygon& a, const Pose& pose_a,  //
                                                const ConvexPolygon& b, const Pose& pose_b);

}  // namespace sunder::planar
