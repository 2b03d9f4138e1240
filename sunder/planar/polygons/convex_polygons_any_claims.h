// Certificates of answers about a set of convex polygons (docs/claims.md, "polygons": each is a ring, flat or not).
//
// Cost: where two meet, linear in all vertices, and as polygons_contact on these two where touching is allowed; else
// O((n + k) log n) for n edges in all and k contacts of theirs. None throws, but for want of memory.
#pragma once

#include <sunder/planar/polygons/convex_polygons_any.h>

#include <span>
#include <string>

namespace sunder::planar {

// Requires an answer about these polygons under this rule and with these groups. The certificate must be true: the
// common point is computed here, or the sweep over all edges.
std::string certificate_text(std::span<const ConvexPolygon> polygons, Allowed allowed,
                             const ConvexPolygonsAnswer& answer, Groups groups = {});

}  // namespace sunder::planar
