// Shamos & Hoey 1976, Theorem 7: the sweep of polygon_sweep.h, up to the first contact that counts.
#include <sunder/planar/set/first_that_counts.h>
#include <sunder/planar/set/polygon_sweep.h>
#include <sunder/planar/set/polygons_any.h>

namespace sunder::planar {

PolygonsAnswer polygons_any_by_sweep(std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  PolygonEdges edges(pointers_to(polygons));
  PolygonsAnswer answer;
  PolygonSweep sweep(edges, options, first_that_counts(answer, options.allowed));
  sweep.run();
  answer.cost = sweep.cost;
  classify(polygons, answer);
  return answer;
}

}  // namespace sunder::planar
