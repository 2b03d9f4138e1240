// The events of a sweep in a certificate file (docs/claims.md, "Sweeps").
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/planar/sweep/sweep_events.h>

#include <string_view>

namespace sunder::planar {

// The claims of a statement: the one of this kind, with the events.
void write_sweep(ClaimsWriter& file, std::string_view claim, const SweepEvents& events);

}  // namespace sunder::planar
