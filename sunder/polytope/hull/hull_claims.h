// Writes what is proved of the convex hull of points of R^d into a certificate file (docs/claims.md), as a statement
// `polytope_hull`: its facets, or that it is a segment or a point.
// Also called: proof logging.
// None throws, but for want of memory, or what the writer's sink throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/polytope/hull/convex_hull.h>

#include <string>

namespace sunder::polytope {

// The table, and the statement: all of a file but its origin and its end. Requires the hull to be that of the points.
// Cost: of each point that is no vertex, the way across simplices to the one behind which it is.
void write_hull(ClaimsWriter& file, const std::string& name, const Polytope& points, const ConvexHull& hull);

}  // namespace sunder::polytope
