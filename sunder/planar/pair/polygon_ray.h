// What has a ray in common with a placed convex polygon? Nothing, a point, a part of an edge, or a segment through it.
// Also called: ray shooting; ray casting.
//
// As polygon_line.h, of which it is the part from the ray's beginning on; that beginning, where it is in the polygon,
// is an end of the answer. Where the line meets the polygon and the ray does not, no vertex is named. A point on the
// line is compared with an end of the common part by its side of the edge there, so no point is constructed. These
// functions throw only when memory runs out. Source: Chazelle & Dobkin 1987, section 2.3: "the extension to the case
// in which L is a line segment".
#pragma once

#include <sunder/planar/object/line.h>
#include <sunder/planar/pair/polygon_cut.h>

namespace sunder::planar {

// Cost: at most 3 log2 n + 5 probes, one sign each, and at most four signs.
PolygonCut polygon_ray(const ConvexPolygon& polygon, const Pose& pose, const Ray& ray);
inline PolygonCut polygon_ray(const ConvexPolygon& polygon, const Ray& ray) {
  return polygon_ray(polygon, Pose(), ray);
}

// All vertices, and exact fractions: the oracle.
PolygonCut polygon_ray_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Ray& ray);

}  // namespace sunder::planar
