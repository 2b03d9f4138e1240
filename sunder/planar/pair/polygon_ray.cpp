#include <sunder/planar/pair/cut_by_scan.h>
#include <sunder/planar/pair/line_search.h>
#include <sunder/planar/pair/polygon_ray.h>

namespace sunder::planar {

PolygonCut polygon_ray(const ConvexPolygon& polygon, const Pose& pose, const Ray& ray) {
  return cut_and_clip(polygon, pose, ray.a, ray.b, false);
}

PolygonCut polygon_ray_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Ray& ray) {
  return cut_by_scan(polygon, pose, ray.a, ray.b, {.a = true, .b = false});
}

}  // namespace sunder::planar
