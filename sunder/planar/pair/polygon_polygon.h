// Do two placed convex polygons meet? (Segments and points are polygons of two vertices and of one.)
//
// The objects are closed: touching is meeting. The answer is exactly right for the doubles given, and comes with its
// certificate, in which the polygons are bodies in the plane z = 0 (certificate/pair.h).
// Also called: convex polygon intersection test; collision detection; separating axis test.
//   P1. The verdict is that of the exact images of the vertices under the poses.
//   P2. Swapping the objects, and scaling or shifting both exactly, does not change the verdict.
//   P3. The certificate passes the absolute check of certificate/check.h. It names four vertices at most where the
//       polygons meet; where they are apart, its direction is the normal of an edge, or the difference of two vertices
//       (parallel segments, and points), and so it names a pair of parallel lines that part the polygons.
//   P4. The answer, the certificate and the counts are the same for every compiler.
// All methods have one signature. None allocates while filters decide, and none throws, but for want of memory.
// Sources: Chazelle & Dobkin 1987, section 2.4 and Theorem 4; Barba & Langerman 2015, section 2.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>

namespace sunder {

namespace planar {

// The front door: the fastest that was measured: a triangle in each; a triangle of A - B and a search behind one of its
// sides, in doubles, whose evidence is checked exactly (cone_search.h); where it does not hold, as near contact, the
// search over the whole difference finishes. Cost: at most 7 (log2 n + log2 m) + 24 probes, less than 3 of them mostly.
PairAnswer polygon_polygon(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b);

// By one search for the edge of the difference A - B through which a ray leaves it: signs only, no constructed points,
// so that there is nothing to finish. Cost: at most 4 (log2 n + log2 m) + 8 probes.
PairAnswer polygon_polygon_by_difference(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b);

// By halving two chains, one of each polygon (Chazelle & Dobkin 1987, section 2.4, IGG and Theorem 4): see halving.h.
// Its evidence is made of signs; should it ever not hold, the exact search by the difference finishes (no such case is
// known). Points and segments go to that search at once, which does not count as finishing.
// Cost: at most 20 (log2 n + log2 m) + 20 probes, and log2 n + log2 m + 1 rounds.
PairAnswer polygon_polygon_by_halving(const ConvexPolygon& a, const Pose& pose_a,  //
                                      const ConvexPolygon& b, const Pose& pose_b);

// A triangle inside one against three half-planes around the other (Barba & Langerman 2015, section 2), in doubles; its
// evidence is checked exactly, and where it does not hold, the exact search finishes. Points and segments as above.
// Cost: at most 3 (log2 n + log2 m) + 20 probes, or 6 (log2 n + log2 m) + 20 where the exact search finishes.
PairAnswer polygon_polygon_by_triangles(const ConvexPolygon& a, const Pose& pose_a,  //
                                        const ConvexPolygon& b, const Pose& pose_b);

// By the nearest point of A - B to the origin (Gilbert, Johnson & Keerthi 1988, in the plane), in doubles; evidence,
// finishing, points and segments as above. At most 64 rounds of log2 n + log2 m + O(1) probes each.
PairAnswer polygon_polygon_by_gjk(const ConvexPolygon& a, const Pose& pose_a,  //
                                  const ConvexPolygon& b, const Pose& pose_b);

// Against every edge of both: slow and obvious, the oracle of the others. Cost: O((n + m)^2) probes.
PairAnswer polygon_polygon_by_scan(const ConvexPolygon& a, const Pose& pose_a,  //
                                   const ConvexPolygon& b, const Pose& pose_b);

// Touching or overlapping? Cost: as the front door.
Relation polygon_polygon_contact(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b,
                                 const Pose& pose_b);

}  // namespace planar

// The front door under its short name.
inline PairAnswer intersect(const planar::ConvexPolygon& a, const planar::Pose& pose_a, const planar::ConvexPolygon& b,
                            const planar::Pose& pose_b) {
  return planar::polygon_polygon(a, pose_a, b, pose_b);
}
inline PairAnswer intersect(const planar::ConvexPolygon& a, const planar::ConvexPolygon& b) {
  return planar::polygon_polygon(a, planar::Pose(), b, planar::Pose());
}

}  // namespace sunder
