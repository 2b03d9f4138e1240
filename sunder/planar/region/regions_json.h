// Tables and statements about half-planes in certificate files (docs/claims.md, "half_planes").
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/object/polygon_sides.h>
#include <sunder/planar/region/region.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::planar {

// The table of half-planes.
void write_half_planes(ClaimsWriter& file, const Constraints& given);
void write_half_planes(ClaimsWriter& file, const HalfPlanes& given);

// The verdict, the sides and the claims of the statement that is open, and its end. Requires the region with its
// evidence.
template <class Given>
void write_region(ClaimsWriter& file, const Given& given, const Region& region);

extern template void write_region(ClaimsWriter&, const Constraints&, const Region&);
extern template void write_region(ClaimsWriter&, const HalfPlanes&, const Region&);
extern template void write_region(ClaimsWriter&, const PolygonSides&, const Region&);

}  // namespace sunder::planar
