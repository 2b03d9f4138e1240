// From a triangulated hull to the hull with maximal facets. Internal to solid/hull.
// Also called: facet merging.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/hull/convex_hull.h>
#include <sunder/solid/hull/quickhull.h>

#include <span>
#include <vector>

namespace sunder::solid {

// The hull up to the order of in_canonical_order. Requires triangles as quickhull gives them.
// Cost: linear.
ConvexHull merge_coplanar(std::span<const Point3> points, const std::vector<Triangle>& triangles);

}  // namespace sunder::solid
