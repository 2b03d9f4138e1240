// The certificate file of a linear program (docs/claims.md, "linear_program").
//
// None throws, but for want of memory. Cost: linear, and a few exact numbers.
#pragma once

#include <sunder/certificate/origin.h>
#include <sunder/planar/region/linear_program.h>

#include <string>

namespace sunder::planar {

// Requires the answer for these half-planes and this objective. `Given` is Constraints or HalfPlanes. The certificate
// must be true: its point is computed here. origin: where the half-planes come from. region: theirs, with its evidence;
// it gets a statement too.
template <class Given>
std::string certificate_text(const Given& given, const Objective& objective, const LinearProgramAnswer& answer,
                             const Origin& origin = {}, const Region* region = nullptr);

extern template std::string certificate_text(const Constraints&, const Objective&, const LinearProgramAnswer&,
                                             const Origin&, const Region*);
extern template std::string certificate_text(const HalfPlanes&, const Objective&, const LinearProgramAnswer&,
                                             const Origin&, const Region*);

}  // namespace sunder::planar
