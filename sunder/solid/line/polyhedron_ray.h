// What has a ray in common with a placed convex polyhedron? Nothing, a point, a part of its surface, or a segment
// through it.
// Also called: ray shooting; ray casting; ray tracing.
//
// As polyhedron_line.h, of which it is the part from the ray's beginning on; that beginning, where it is in the body,
// is an end of the answer. It is compared with an end of the common part by its side of the facet there, so no point is
// constructed. None throws, but for want of memory.
#pragma once

#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/object/line.h>

namespace sunder::solid {

// Cost: that of polyhedron_line, and at most two signs.
PolyhedronCut polyhedron_ray(const ConvexPolyhedron& body, const Pose& pose, const Ray& ray);
inline PolyhedronCut polyhedron_ray(const ConvexPolyhedron& body, const Ray& ray) {
  return polyhedron_ray(body, Pose(), ray);
}

// As polyhedron_line_by_drums.
PolyhedronCut polyhedron_ray_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Ray& ray);

// All facets, exactly: the oracle. It gives no evidence.
PolyhedronCut polyhedron_ray_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Ray& ray);

}  // namespace sunder::solid
