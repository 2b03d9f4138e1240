#include <sunder/planar/set/convex_polygons_any.h>

namespace sunder::planar {

ConvexPolygonsAnswer convex_polygons_any(std::span<const ConvexPolygon> polygons, const SetOptions& options) {
  return convex_polygons_any_by_grid(polygons, options);
}

}  // namespace sunder::planar
