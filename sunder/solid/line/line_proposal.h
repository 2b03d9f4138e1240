// What a search has found about a convex polyhedron with an inside and a line: a claim, and the facets that should
// prove it. A proposal may be wrong in any way: polyhedron_line_answer.h disposes of it.
#pragma once

#include <cstdint>

namespace sunder::solid {

struct LineProposal {
  enum class Claim : std::uint8_t {
    through,  // the line comes in through a point of facet `enters`, and goes out through one of facet `leaves`
    apart,    // where it comes through the plane of facet `enters` from outside it is beyond the plane of `leaves`
              // already, through which it does not come from outside
  };
  Claim claim = Claim::through;
  std::uint32_t enters = 0, leaves = 0;
};

}  // namespace sunder::solid
