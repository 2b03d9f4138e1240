#include <sunder/planar/set/polygons_any.h>

namespace sunder::planar {

PolygonsAnswer polygons_any(std::span<const Polygon> polygons, const SetOptions& options) {
  return polygons_any_by_boxes(polygons, options);
}

}  // namespace sunder::planar
