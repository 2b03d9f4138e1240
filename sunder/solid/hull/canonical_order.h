// The order in which a hull is handed out. Internal to solid/hull.
#pragma once

#include <sunder/solid/hull/convex_hull.h>

#include <cstddef>

namespace sunder::solid {

// The same hull as H1 to H5 demand it. Takes the vertices in any order, and so numbered; the facets in any order; each
// facet and each cycle of neighbours beginning anywhere. Requires that the vertices are less than point_count.
// Cost: linear in the sizes, besides sorting the facets that have their lowest vertex in common.
ConvexHull in_canonical_order(const ConvexHull& hull, std::size_t point_count);

}  // namespace sunder::solid
