// The certificate file of a kernel (docs/claims.md, "kernel").
//
// None throws, but for want of memory. Cost: linear.
#pragma once

#include <sunder/certificate/origin.h>
#include <sunder/planar/region/kernel.h>

#include <string>

namespace sunder::planar {

// Requires the kernel of this polygon with its evidence.
std::string certificate_text(const PolygonSides& polygon, const Region& kernel, const Origin& origin = {});

}  // namespace sunder::planar
