// The boxes of the polygons find the pairs that may meet.
#include <sunder/planar/set/first_that_counts.h>
#include <sunder/planar/set/polygon_pairs.h>
#include <sunder/planar/set/polygons_any.h>

namespace sunder::planar {

PolygonsAnswer polygons_any_by_boxes(std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  PolygonsAnswer answer;
  Cost cost;
  if (for_each_meeting_pair(polygons, options, cost, first_that_counts(answer, options.allowed))) {
    answer.cost = cost;
    return answer;
  }
  answer = polygons_any_by_sweep(polygons, options);
  answer.cost.probes += cost.probes;
  return answer;
}

}  // namespace sunder::planar
