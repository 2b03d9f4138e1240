// A grid over the boxes of segments.
#pragma once

#include <sunder/near/box_grid.h>
#include <sunder/planar/object/segments.h>

#include <optional>

namespace sunder::planar {

// With 0.65 cells for each segment: of meshes of 300 to 10^6 segments it is faster than 1 by a tenth, and than 0.3 to
// 0.5 where they are small.
inline std::optional<BoxGrid> grid_over(const Segments& segments) {
  return BoxGrid::over(segments.all(), segments.extents(), 0.65);
}

}  // namespace sunder::planar
