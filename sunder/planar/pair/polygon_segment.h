// What has a closed segment in common with a placed convex polygon? Nothing, a point, a part of an edge, or a segment
// through it.
// Also called: segment clipping.
//
// As polygon_line.h, of which it is the part between the segment's ends; these, where they are in the polygon, are ends
// of the answer. A segment of length zero is a point. Where its line meets the polygon and it does not, no vertex is
// named: for a certificate ask polygon_polygon.h with the segment as a polygon of two vertices. Requires finite
// coordinates.
// None throws, but for want of memory. Source and method: see polygon_ray.h.
#pragma once

#include <sunder/planar/object/segments.h>
#include <sunder/planar/pair/polygon_cut.h>

namespace sunder::planar {

// Cost: at most 3 log2 n + 5 probes, one sign each, and at most eight signs.
PolygonCut polygon_segment(const ConvexPolygon& polygon, const Pose& pose, const Segment& segment);
inline PolygonCut polygon_segment(const ConvexPolygon& polygon, const Segment& segment) {
  return polygon_segment(polygon, Pose(), segment);
}

// All vertices, and exact fractions: the oracle.
PolygonCut polygon_segment_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Segment& segment);

}  // namespace sunder::planar
