// The sweep that met no contact, for certificates of version 1 (docs/certificates-sets.md): of polygons.
#pragma once

#include <cstdint>
#include <vector>

namespace sunder::planar {

// `events`: the ends in the order of the sweep, 2 i for the first end of member i and 2 i + 1 for its last; `below`:
// for each first end, in that order, the member just below it then, or 0xffffffff.
struct SweepTranscript {
  std::vector<std::uint32_t> events;
  std::vector<std::uint32_t> below;
};

}  // namespace sunder::planar
