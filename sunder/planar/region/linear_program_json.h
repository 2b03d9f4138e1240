// The certificate file of a linear program (docs/claims.md, "linear_program").
#pragma once

#include <sunder/planar/region/linear_program.h>

#include <string>

namespace sunder::planar {

// Requires the answer for these half-planes and this objective. `Given` is Constraints or HalfPlanes. The certificate
// must be true: its point is computed here.
template <class Given>
std::string certificate_text(const Given& given, const Objective& objective, const LinearProgramAnswer& answer);

extern template std::string certificate_text(const Constraints&, const Objective&, const LinearProgramAnswer&);
extern template std::string certificate_text(const HalfPlanes&, const Objective&, const LinearProgramAnswer&);

}  // namespace sunder::planar
