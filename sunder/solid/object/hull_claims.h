// Certificates of convex hulls (docs/claims.md, "Hulls").
//
// None throws, but for want of memory, or what the writer's sink throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <span>
#include <string>

namespace sunder::solid {

// The table of one body, these points, and the statement of what their hull is. Requires the hull of these points, and
// a name. Time: exact arithmetic for each facet, and for each other point on a few facets: walks over them, begun at
// that which a search in doubles proposes. At worst, on facets around two far corners or with very many corners, points
// times facets.
void write_hull(ClaimsWriter& file, const std::string& name, std::span<const Point3> points,
                const ConvexPolyhedron& hull);

// The statement alone, of the body 0 of the table, whose points are the vertices of this one, in their order.
void write_hull_of_vertices(ClaimsWriter& file, const ConvexPolyhedron& hull);

}  // namespace sunder::solid
