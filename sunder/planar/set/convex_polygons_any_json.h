// Certificates of answers about a set of convex polygons (docs/claims.md, "polygons": each is a ring, flat or not).
#pragma once

#include <sunder/planar/set/convex_polygons_any.h>

#include <span>
#include <string>

namespace sunder::planar {

// Requires an answer about these polygons under this rule and with these groups. The certificate must be true: the
// common point is computed here, or the sweep over all edges.
std::string certificate_text(std::span<const ConvexPolygon> polygons, Allowed allowed,
                             const ConvexPolygonsAnswer& answer, Groups groups = {});

}  // namespace sunder::planar
