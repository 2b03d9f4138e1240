// The certificate files of regions that half-planes bound (docs/claims.md, "half_planes", "kernel",
// "convex_polygons_common_part"), and their tables and statements.
//
// None throws, but for want of memory. Cost: linear, but for convex polygons.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/region/kernel.h>

#include <span>
#include <string>
#include <vector>

namespace sunder::planar {

// Requires the region of these half-planes with its evidence. `Given` is Constraints or HalfPlanes; PolygonSides: the
// kernel of this polygon, which is simple, and that it is. origin: where they come from.
template <class Given>
std::string certificate_text(const Given& given, const Region& region, const Origin& origin = {});

extern template std::string certificate_text(const Constraints&, const Region&, const Origin&);
extern template std::string certificate_text(const HalfPlanes&, const Region&, const Origin&);
extern template std::string certificate_text(const PolygonSides&, const Region&, const Origin&);

// What is common to these polygons, proved: by the common part of all their sides, whatever method the answer came
// from. Requires fewer than 2^31 sides in all. Cost: O(n log n) signs for n vertices in all.
std::string certificate_text(std::span<const ConvexPolygon> polygons, const Origin& origin = {});

// The half-planes whose common part each polygon is, polygon after polygon: of three vertices or more, to the left of
// edge 0, 1, ...; of a segment, of both its edges, then x or, where it is vertical, y at most and at least those of its
// ends; of a point, x at most, y at most, x at least, y at least its own.
std::vector<HalfPlane> sides_of(std::span<const ConvexPolygon> polygons);

// The statement about the table of half-planes that the file has. Requires their region with its evidence. `Given` is
// Constraints or HalfPlanes.
template <class Given>
void write_region_statement(ClaimsWriter& file, const Given& given, const Region& region);

extern template void write_region_statement(ClaimsWriter&, const Constraints&, const Region&);
extern template void write_region_statement(ClaimsWriter&, const HalfPlanes&, const Region&);

// The table of half-planes.
void write_half_planes(ClaimsWriter& file, const Constraints& given);
void write_half_planes(ClaimsWriter& file, const HalfPlanes& given);

}  // namespace sunder::planar
