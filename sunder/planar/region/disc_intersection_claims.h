// The certificate file of the common part of discs (docs/claims.md, "circles_common_part"): whether it is empty, a
// point, or a region, and which arcs bound it.
//
// None throws, but for want of memory. Cost: linear; of a region, as disc_intersection_by_division.
#pragma once

#include <sunder/certificate/origin.h>
#include <sunder/planar/region/disc_intersection.h>

#include <string>

namespace sunder::planar {

// Requires the common part of these circles. The certificate must be true: its exact numbers are computed here.
std::string certificate_text(const Discs& circles, const DiscIntersection& part, const Origin& origin = {});

}  // namespace sunder::planar
