// From a triangulated hull to the hull with maximal facets. Internal to solid/hull.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/hull/convex_hull.h>
#include <sunder/solid/hull/quickhull.h>

#include <span>
#include <vector>

namespace sunder::solid {

// Requires triangles as quickhull gives them. Cost: O(n + t log t) for n points and t triangles.
ConvexHull merge_coplanar(std::span<const Point3> points, const std::vector<Triangle>& triangles);

}  // namespace sunder::solid
