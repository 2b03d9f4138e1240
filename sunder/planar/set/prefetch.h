// Fetching segments before their turn comes: where their order has nothing to do with memory, all else waits for them.
#pragma once

#include <sunder/planar/object/segments.h>

namespace sunder::planar {

// Both of its cache lines: a segment may begin in one and end in the next.
inline void prefetch(const Segment& s) {
  __builtin_prefetch(&s.a);
  __builtin_prefetch(&s.b.y);
}

}  // namespace sunder::planar
