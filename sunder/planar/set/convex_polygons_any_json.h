// The certificate file of an answer about a set of convex polygons (docs/certificates-sets.md, "convex_polygons_any").
#pragma once

#include <sunder/planar/set/convex_polygons_any.h>

#include <span>
#include <string>

namespace sunder::planar {

// Requires an answer about these polygons under this rule and with these groups; one of `none` with its transcript,
// without groups, and touching not allowed: for that the format has no transcript. The certificate must be true: exact
// directions and weights are computed here.
std::string certificate_text(std::span<const ConvexPolygon> polygons, Allowed allowed,
                             const ConvexPolygonsAnswer& answer, Groups groups = {});

}  // namespace sunder::planar
