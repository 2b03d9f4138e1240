// Where edges of two polygons cross, do these overlap? For use by the methods of polygons_any and polygons_all.
//
// Each polygon has its inside on one side of its edge, and there a sector along either half of the edge that it fills,
// as its other edges at the point end there, in directions between. Where one polygon has no other edges there, it
// fills all of its side, and of the four quarters between the two edges one is on the inner side of both: in it the
// other polygon fills a sector. So they overlap. But where both have a vertex at the point, notches of the one may hold
// what the other fills: only all edges around the point tell. (If, besides, the insides of both are connected, they
// overlap somewhere: each fills sectors along both halves of its edge, which take turns around the point; a way from
// one to the other inside of the first polygon, closed in the point, parts the two of the second.)
#pragma once

#include <sunder/planar/object/polygon.h>

#include <cstdint>

namespace sunder::planar {

// Is there none, or just one of the polygons, that has a vertex where edge e of a and edge f of b cross? Then they
// overlap around that point. Requires that these cross. `probes` grows by the boxes and vertices looked at. Cost:
// nothing where one is strictly convex; else what the boxes of edges that hold the point take, mostly logarithmic.
bool overlap_at_crossing(const Polygon& a, std::uint32_t e, const Polygon& b, std::uint32_t f, std::uint64_t& probes);

}  // namespace sunder::planar
