// Do a placed convex polyhedron and a placed flat convex polygon meet (IHG)?
// Also called: polygon-polyhedron intersection; clipping test.
//
// A polygon of space is a frame and vertices of the plane: so it is a ConvexPolyhedron of dimension 2 under a pose, for
// instance with vertices (s, t, 0), and planar by construction. All that polyhedron_polyhedron.h promises holds, and
// all of its methods answer: this header has the front door, the oracle, and what goes by drums.
#pragma once

#include <sunder/solid/pair/polyhedron_polyhedron.h>

namespace sunder::solid {

// The front door: polyhedron_polyhedron. Cost: O(log n + log m) probes.
inline PairAnswer polyhedron_polygon(const ConvexPolyhedron& body, const Pose& pose,  //
                                     const ConvexPolyhedron& polygon, const Pose& pose_of_polygon) {
  return polyhedron_polyhedron(body, pose, polygon, pose_of_polygon);
}

// By drums (represent/drums.h): the section of the body by the polygon's plane, which exists only implicitly, against
// the polygon, by the planar search for two polygons: first a polygon inside of the section, whose corners are on
// slices, then what the section has beside the corners where that ends. In doubles and in double-doubles; where neither
// holds, the exact method decides, as it does for a body without an inside, and for a segment or a point.
// Cost: where own proposals hold, at most 75 log2 p log2 (p + q) probes, p vertices of the body and q of the polygon, 8
// or more (the constant tested): looks at vertices of the polygon, and accesses to edges of drums, times their steps.
// The exact method finishes at most 1 % (tested; 0.4 % seen to the last bit).
// Source: CD87 section 3.4, Lemma 9, Theorem 10. Departures: section/section_search.h; the planar search is the one
// over the Minkowski difference (planar/pair/minkowski_difference_search.h), in place of IGG.
PairAnswer polyhedron_polygon_by_drums(const ConvexPolyhedron& body, const Pose& pose,  //
                                       const ConvexPolyhedron& polygon, const Pose& pose_of_polygon);

// By one exact linear program over all vertices: the oracle.
inline PairAnswer polyhedron_polygon_by_scan(const ConvexPolyhedron& body, const Pose& pose,  //
                                             const ConvexPolyhedron& polygon, const Pose& pose_of_polygon) {
  return polyhedron_polyhedron_by_scan(body, pose, polygon, pose_of_polygon);
}

}  // namespace sunder::solid
