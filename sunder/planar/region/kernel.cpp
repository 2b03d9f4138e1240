#include <sunder/planar/region/kernel.h>

namespace sunder::planar {

Region kernel(const PolygonSides& sides, const RegionOptions& options) {
  return half_plane_intersection(sides, options);
}

Region kernel_by_half_plane_intersection(const PolygonSides& sides, const RegionOptions& options) {
  return half_plane_intersection_by_sort(sides, options);
}

Region kernel_by_scan(const PolygonSides& sides, const RegionOptions& options) {
  return half_plane_intersection_by_scan(sides, options);
}

}  // namespace sunder::planar
