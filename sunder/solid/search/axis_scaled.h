// How needles are searched: whatever the search, two bodies at once.
#pragma once

#include <sunder/base/function_ref.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/search/proposal.h>

namespace sunder::solid {

// What propose(a, b, holds) proposes; of the bodies with the axes of the world scaled, each by a power of two, so that
// they have about the same size along all, where floating point would not see along one what there is, for what there is
// along another. Whatever is lost, the exact checks are about the bodies as they are. True where a proposal held.
bool propose_axis_scaled_where_wanted(const Placed& a, const Placed& b, const Holds& holds,
                                      FunctionRef<bool(const Placed&, const Placed&, const Holds&)> propose);

}  // namespace sunder::solid
