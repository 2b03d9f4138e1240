// What has a segment in common with a placed convex polyhedron? Nothing, a point, a part of its surface, or a segment
// through it.
// Also called: segment clipping; segment casting; line of sight.
//
// As polyhedron_ray.h, with both ends. A segment whose ends are one point asks whether that is in the body, and where.
// None throws, but for want of memory.
#pragma once

#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/object/line.h>

namespace sunder::solid {

// Cost: that of polyhedron_line, and at most four signs.
PolyhedronCut polyhedron_segment(const ConvexPolyhedron& body, const Pose& pose, const Segment& segment);
inline PolyhedronCut polyhedron_segment(const ConvexPolyhedron& body, const Segment& segment) {
  return polyhedron_segment(body, Pose(), segment);
}

// As polyhedron_line_by_drums.
PolyhedronCut polyhedron_segment_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Segment& segment);

// All facets, exactly: the oracle. It gives no evidence.
PolyhedronCut polyhedron_segment_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Segment& segment);

}  // namespace sunder::solid
