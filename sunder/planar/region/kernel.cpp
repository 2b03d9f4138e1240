#include <sunder/planar/region/kernel.h>

namespace sunder::planar {

Region kernel(const PolygonSides& sides, const RegionOptions& options) { return half_planes(sides, options); }

Region kernel_by_half_planes(const PolygonSides& sides, const RegionOptions& options) {
  return half_planes_by_sort(sides, options);
}

Region kernel_by_scan(const PolygonSides& sides, const RegionOptions& options) {
  return half_planes_by_scan(sides, options);
}

}  // namespace sunder::planar
