// The certificate file of the common part of half-planes (docs/claims.md, "half_planes").
//
// None throws, but for want of memory. Cost: linear.
#pragma once

#include <sunder/certificate/origin.h>
#include <sunder/planar/region/region.h>

#include <string>

namespace sunder::planar {

// Requires the region of these half-planes with its evidence. `Given` is Constraints or HalfPlanes. origin: where
// they come from.
template <class Given>
std::string certificate_text(const Given& given, const Region& region, const Origin& origin = {});

extern template std::string certificate_text(const Constraints&, const Region&, const Origin&);
extern template std::string certificate_text(const HalfPlanes&, const Region&, const Origin&);

}  // namespace sunder::planar
