// What has a line in common with a placed convex polygon (IGL)? Nothing, a point, an edge, or a segment through it.
// Also called: line clipping; stabbing line.
//
// The answer names features (polygon_cut.h); it is exactly right for the doubles given. The line is in the world.
//   P1. The answer is that of the exact images of the vertices under the pose.
//   P2. All methods give the same answer, but for decided_by and the cost.
// A polygon of three vertices or more has in common with a line nothing (then the nearest vertex is named), one vertex,
// an edge with its two vertices, or a segment through its inside, between two features of the boundary. One of two
// vertices, a segment, has one point, also in its inside, or all of it; one of one vertex has that.
// None but the scan allocates while filters decide, and none throws, but for want of memory.
// Source: Chazelle & Dobkin 1987, section 2.3, Theorem 3.
// Departures: where the paper's function f compares signs with that of f(p_1), p_1 may be on the line here: then
// another of the first three vertices takes its place. Its two binary searches for the points of intersection are
// counted, unlike in the paper's 2.88 log2 n.
#pragma once

#include <sunder/planar/object/line.h>
#include <sunder/planar/pair/polygon_cut.h>

namespace sunder::planar {

// The front door: an extreme vertex by the directions of edges. Cost: at most 3 log2 n + 5 probes, one sign each.
PolygonCut polygon_line(const ConvexPolygon& polygon, const Pose& pose, const Line& line);
inline PolygonCut polygon_line(const ConvexPolygon& polygon, const Line& line) {
  return polygon_line(polygon, Pose(), line);
}

// As in the paper, with the extreme vertices of Lemma 2 by Fibonacci search. Cost: at most 4.89 log2 n + 11 probes.
PolygonCut polygon_line_by_fibonacci(const ConvexPolygon& polygon, const Pose& pose, const Line& line);

// All vertices: the oracle. Cost: n probes.
PolygonCut polygon_line_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Line& line);

}  // namespace sunder::planar
