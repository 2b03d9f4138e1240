// The facets and vertices of the hull of points that span their space, of doubles or of fractions: what convex_hull.h
// and vertices.h have in common.
#pragma once

#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/predicate/point/simplex_plane.h>

#include <cstdint>
#include <vector>

namespace sunder::polytope {

// Some of the points that span what all of these do, one more than its dimension. Exact.
std::vector<std::uint32_t> spanning(const PlanePoints& points, const std::vector<std::uint32_t>& among);

// Fills in vertices, facets, simplices and cost (C2 to C4 of ConvexHull), of the points `all`, which span their space.
// Of equal ones it takes any. Throws as convex_hull(). False, with nothing filled in, where it gives up
// (QuickhullCost::is_degenerate()).
enum class Degenerate : std::uint8_t { goes_on, gives_up };
bool hull_of_full(const PlanePoints& points, std::vector<std::uint32_t> all, std::uint64_t most, ConvexHull& hull,
                  Degenerate degenerate = Degenerate::goes_on);

}  // namespace sunder::polytope
