// The certificate file of the common part of convex polygons (docs/claims.md, "convex_polygons_common_part").
//
// None throws, but for want of memory.
#pragma once

#include <sunder/certificate/origin.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/region/region.h>

#include <span>
#include <string>
#include <vector>

namespace sunder::planar {

// The half-planes whose common part each polygon is, polygon after polygon: of three vertices or more, to the left of
// edge 0, 1, ...; of a segment, of both its edges, then x or, where it is vertical, y at most and at least those of its
// ends; of a point, x at most, y at most, x at least, y at least its own.
std::vector<HalfPlane> sides_of(std::span<const ConvexPolygon> polygons);

// What is common to these polygons, proved: by the common part of all their sides (half_planes), whatever method the
// answer came from. Requires fewer than 2^31 sides in all. Cost: O(n log n) signs for n vertices in all.
std::string certificate_text(std::span<const ConvexPolygon> polygons, const Origin& origin = {});

}  // namespace sunder::planar
