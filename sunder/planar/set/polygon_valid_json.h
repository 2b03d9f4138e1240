// Certificates that polygons are valid, or of what is wrong with them (docs/claims.md, "Valid polygons").
//
// Requires finite coordinates and fewer than 2^31 vertices. None throws, but for want of memory, or what the writer's
// sink throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/set/polygon_valid.h>

#include <cstdint>
#include <span>

namespace sunder::planar {

// Adds the parts to the table `polygons`, which is open. A last vertex that repeats its ring's first is left out.
void write_parts(ClaimsWriter& file, std::span<const PolygonRings> parts);

// The statement that the parts of a multipolygon are valid; in the table these are first_part and those that follow.
// Requires that it is true. O((n + k) log n) time for n edges, k crossings.
void write_valid(ClaimsWriter& file, std::span<const PolygonRings> parts, std::uint32_t first_part, PolygonRule rule);

// The statement of a defect, as polygon_defects names it. False, and nothing is written: the defect is that two rings
// cross in a vertex, and no point near it shows it; or that the interior is not connected, and another defect hides
// that. Cost: linear in the edges for each point that is looked at, mostly one; for `disconnected`, as for write_valid.
bool write_defect(ClaimsWriter& file, std::span<const PolygonRings> parts, std::uint32_t first_part, PolygonRule rule,
                  const PolygonDefect& defect);

}  // namespace sunder::planar
