// Qhull as the peer of solid/hull.
#pragma once

#include <cstddef>
#include <vector>

#include "../scenarios.h"

namespace bench {

struct QhullTiming {
  double seconds = 0;  // of qh_new_qhull: from points in memory to facets in memory, setting-up included
  std::size_t facets = 0;
  std::size_t vertices = 0;
};

QhullTiming time_qhull(const std::vector<Vec>& points, const char* options);

}  // namespace bench
