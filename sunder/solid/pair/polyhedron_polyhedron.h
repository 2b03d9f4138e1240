// Do two placed convex polyhedra meet?
// Also called: collision detection; narrow phase; convex polyhedron intersection test.
//
// The objects are closed: touching is meeting. The answer is exactly right for the doubles given, and comes with its
// certificate.
//   P1. The verdict is that of the exact images of the vertices under the poses.
//   P2. Swapping the objects, and scaling or shifting both exactly, does not change the verdict.
//   P3. The certificate passes the absolute check of certificate/check.h.
//   P4. The answer, the certificate and the counts are the same for every compiler, thread count and vector unit.
// All methods have one signature. None allocates while filters decide, and none throws, but for want of memory.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

namespace sunder {

namespace solid {

using sunder::PairAnswer;

// The front door: the fastest method measured, by GJK. A pose maps its body's frame to the world, where the two meet or
// are apart, in whatever unit the coordinates have. Cost: as polyhedron_polyhedron_by_gjk.
PairAnswer polyhedron_polyhedron(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                 const ConvexPolyhedron& b, const Pose& pose_b);

// By a floating-point search over the vertex graph (Gilbert, Johnson, Keerthi 1988), which proposes evidence, and an
// exact simplex method for what the search could not certify. Cost: at most 100 steps in doubles and 100 in
// double-doubles, each of O(log n + log m) probes on every body; where neither decides, some five to thirty exact
// pivots of O(log n + log m) probes, and where these do not end, a few more for each level of the hierarchies.
PairAnswer polyhedron_polyhedron_by_gjk(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                        const ConvexPolyhedron& b, const Pose& pose_b);

// By the closest points of the levels of both bodies' hierarchies, from the top down (Dobkin and Kirkpatrick 1990), in
// doubles and then in double-doubles, which propose evidence; the same exact method for what they could not certify.
// The first question about a body makes its hierarchy, in O(n).
// Cost: at most 68 log2^2 n probes, n the larger body, of 8 vertices and more (tested, not proved: of steps after the
// bottom is reached the code allows 100), whatever the degrees and however small the other; where nothing is certified,
// the exact pivots as above.
// Source: Dobkin, Kirkpatrick 1990; BL15 section 4, Lemma 4.2. Departures: vertices beyond a plane by walks over
// sectors of normal cones, so that degrees need no bound (represent/hierarchy_walk.h); one step on a level.
PairAnswer polyhedron_polyhedron_by_hierarchy(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                              const ConvexPolyhedron& b, const Pose& pose_b);

// By a walk between two spaces: one body in its own, and the polar of the other in its (Barba and Langerman 2015), down
// the hierarchies of both, in doubles and then in double-doubles, which propose evidence; the same exact method for
// what they could not certify. The polar is that of the longer body, where one is flat that of the other, and where
// both are, this is polyhedron_polyhedron_by_hierarchy. The first question about a body makes its hierarchy, or that of
// its polar, in O(n).
// Cost: at most 80 (log2 n + log2 m) probes for 8 vertices and more (the constant tested), whatever the degrees; where
// nothing is certified, the exact pivots as above.
// Source: BL15 section 5, Theorem 5.1.
PairAnswer polyhedron_polyhedron_by_polar(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                          const ConvexPolyhedron& b, const Pose& pose_b);

// The same walk down bounded hierarchies (Barba and Langerman's section 4), which looks at all neighbours that come,
// and keeps no sectors; where both bodies are flat, the closest points as above, down bounded hierarchies. The first
// question about a body makes its bounded hierarchy, or that of its polar, in O(n) and some exact arithmetic for each
// edge at a vertex, or side of a facet, that has more than 32.
// Cost: at most 220 (log2 n + log2 m) probes for 8 vertices and more (the constant tested), but for cones of vertices
// that were cut off, each of which takes some binary searches more; where nothing is certified, the exact pivots as
// above.
// Source: BL15 sections 4 and 5, Lemma 4.1, Theorem 5.1. Departures: represent/bounded_hierarchy.h.
PairAnswer polyhedron_polyhedron_by_bounded(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                            const ConvexPolyhedron& b, const Pose& pose_b);

// By the drums of both bodies (represent/drums.h): the one with fewer vertices is cut by planes, whose sections are
// asked whether they meet the other; in doubles and then in double-doubles. Where neither holds, the exact method
// decides, as it does for two bodies of which one is a segment or a point, or both are flat; a flat polygon and a body
// with an inside are asked about by polyhedron_polygon_by_drums.
// Cost: where own proposals hold, at most 140 log2 p log2 q log2 (p + q) probes, p and q the vertices of the bodies, 8
// or more (the constant tested), times the steps of an access to an edge of a drum, which are counted: 1 where drums
// are listed, log2 of the number of edges where they are not. The exact method finishes at most 2 % of random pairs,
// 4 % near contact, 10 % to the last bit, on families of bodies that are hard (tested; 0.6, 2.1 and 7 % seen).
//
// Source: CD87 section 3.6, Theorem 13. Departures: in the source file.
PairAnswer polyhedron_polyhedron_by_drums(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                          const ConvexPolyhedron& b, const Pose& pose_b);

// By one exact linear program over all vertices: slow and obvious, the oracle of the others. O(n) memory.
PairAnswer polyhedron_polyhedron_by_scan(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                         const ConvexPolyhedron& b, const Pose& pose_b);

// Touching or overlapping? May cost more than the question whether they meet.
Relation polyhedron_polyhedron_contact(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                       const ConvexPolyhedron& b, const Pose& pose_b);

}  // namespace solid

// The front door under its short name.
inline solid::PairAnswer intersect(const solid::ConvexPolyhedron& a, const solid::Pose& pose_a,
                                   const solid::ConvexPolyhedron& b, const solid::Pose& pose_b) {
  return solid::polyhedron_polyhedron(a, pose_a, b, pose_b);
}
inline solid::PairAnswer intersect(const solid::ConvexPolyhedron& a, const solid::ConvexPolyhedron& b) {
  return solid::polyhedron_polyhedron(a, solid::Pose(), b, solid::Pose());
}

}  // namespace sunder
