// What a query cost, in counts that are exact and the same on every machine (times are not).
#pragma once

#include <cstdint>

namespace sunder {

struct Cost {
  std::uint64_t probes = 0;      // vertices whose coordinates were looked at, by the search or by an exact walk
  std::uint32_t iterations = 0;  // steps of the search (one extreme vertex of each object a step)
  std::uint32_t exact = 0;       // signs that no filter could decide, and directions, so that exact arithmetic did
  std::uint32_t proposals = 0;   // what the search proposed, until one held, if one did
};

}  // namespace sunder
