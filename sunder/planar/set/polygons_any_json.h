// The certificate file of an answer about a set of polygons (docs/certificates-sets.md, "polygons_any").
#pragma once

#include <sunder/planar/set/polygons_any.h>

#include <span>
#include <string>

namespace sunder::planar {

// Requires an answer about these polygons under this rule and with these groups, not by scan; one of `none` with its
// transcript, without groups. Throws Error bad_shape where a ring is one point, for which the format has no form. The
// certificate must be true: the common point is computed here, in time linear in the edges of both polygons, for each
// edge at that point.
std::string certificate_text(std::span<const Polygon> polygons, Allowed allowed, const PolygonsAnswer& answer,
                             Groups groups = {});

}  // namespace sunder::planar
