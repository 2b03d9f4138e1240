// Is a point in a polytope of R^d, 2 <= d <= 6? Inside by which weights, or which hyperplane parts it.
// Also called: point in convex hull; membership in a polytope; point location.
#pragma once

#include <sunder/base/error.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <span>
#include <vector>

namespace sunder::polytope {

// The polytope as it is, and the point; a point on the boundary is in. The answer is that of polytope_polytope of the
// polytope, A, and the polytope of the one point, B, both where they are.
// Throws Error bad_value where a number of the point is not finite; bad_shape where it has not d of them.
PolytopeAnswer polytope_point(const Polytope& polytope, std::span<const double> point);

// Many points at once, one after the other in a row: an answer for each. Of a polytope of points, the simplices and
// directions that decided about points before are tried first, some 64 of each, the last ones.
// Throws Error as above: bad_shape where there is no whole number of points.
std::vector<PolytopeAnswer> polytope_points(const Polytope& polytope, std::span<const double> points);

}  // namespace sunder::polytope
