// What has a line in common with a placed convex polyhedron (IHL)? Nothing, a point, a part of its surface, or a
// segment through it: where does the line come in, and where does it go out?
// Also called: line clipping; stabbing line; ray shooting, ray casting (polyhedron_ray.h); entry and exit.
//
// The answer names features (polyhedron_cut.h); it is exactly right for the doubles given. The line is in the world.
//   P1. The answer is that of the exact images of the vertices under the pose.
//   P2. All methods give the same kind, ends and surface; decided_by, the cost and the evidence are their own.
// A body with an inside has in common with a line nothing, a vertex or a point of an edge, a part of an edge or facet
// of positive length (`along`), or a segment through its inside (`across`). A flat polygon has one point, or in its
// plane a segment `along` it or one of its edges; a segment has one point or all of it; a point has that.
// The first question about a body makes its facet graph (represent/facet_graph.h), in O(n log n). After that none but
// the scan allocates while filters decide, and none throws, but for want of memory.
// Source: CD87 section 3.5 has the question. The method here is not the paper's, which goes by drums: see the .cpp.
#pragma once

#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/object/line.h>

namespace sunder::solid {

// The front door: from facet to facet that rays from a point inside to the line go through. Cost: a few steps of O(log
// n) probes each; where floating point does not tell, as many steps with exact signs.
PolyhedronCut polyhedron_line(const ConvexPolyhedron& body, const Pose& pose, const Line& line);
inline PolyhedronCut polyhedron_line(const ConvexPolyhedron& body, const Line& line) {
  return polyhedron_line(body, Pose(), line);
}

// By drums (represent/drums.h): the section of the body by a plane through the line is a polygon that exists only
// implicitly; where is it furthest to both sides of the line, and which of its sides does the line cross? The first
// question about a body makes its drums. Cost: at most 45 log2^2 n probes for n of 1,000 and more (the constant
// tested), times the steps of an access to an edge of a drum; where what is found does not hold, in doubles and in
// double-doubles, exact steps as above. Source: CD87 section 3.5, Theorem 11. Departures: section/section_search.h.
PolyhedronCut polyhedron_line_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Line& line);

// All facets, exactly: the oracle. It gives no evidence.
PolyhedronCut polyhedron_line_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Line& line);

}  // namespace sunder::solid
