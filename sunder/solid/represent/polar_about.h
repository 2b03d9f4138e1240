// The polar of a convex polyhedron P about any point o inside it, exactly: all y with y.(x - o) <= 1 for every x of P.
// Also called: polar dual, polar body. For searches, about a point that it chooses and in doubles: polar.h.
// Source: BL15 section 3, with o as the origin.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/polar.h>

#include <cstdint>
#include <vector>

namespace sunder::solid {

struct PolarAbout {
  Point3 origin;
  std::vector<PolarVertex> vertices;  // by P's facets, n / h as seen from the origin, h > 0

  // By P's vertices: facet v has the vertices facet_vertices[facet_begin[v] .. facet_begin[v + 1]), counter-clockwise
  // seen from outside.
  std::vector<std::uint32_t> facet_begin, facet_vertices;
};

// Throws Error bad_shape where the dimension is not 3; bad_value where the origin is not finite, or not inside: then
// the polar is unbounded, and the text names a point inside. Cost: O(n), of exact arithmetic.
PolarAbout polar_about(const ConvexPolyhedron& body, const Point3& origin);

// The nearest doubles; beyond their range infinite.
Point3 nearest_point(const PolarVertex& vertex);

}  // namespace sunder::solid
