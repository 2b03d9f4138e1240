// The convex hulls of points, segments and plane sets. Internal to solid/hull.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/hull/convex_hull.h>

#include <cstdint>
#include <span>

namespace sunder::solid {

// All three give the hull up to the order of in_canonical_order.

// The hull of points all equal to point a.
ConvexHull point_hull(std::uint32_t a);

// The hull of points on a line; a and b are the two ends.
ConvexHull segment_hull(std::uint32_t a, std::uint32_t b);

// The hull of points that lie in one plane, not all on a line. Requires an axis (0: x, 1: y, 2: z) that is not
// parallel to the plane. Cost: O(n log n).
// Source: Andrew 1979 (the monotone chain), on the projections along the axis, which are one-to-one.
ConvexHull polygon_hull(std::span<const Point3> points, int axis);

}  // namespace sunder::solid
