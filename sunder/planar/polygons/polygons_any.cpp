// The front door, and the methods whose searches are elsewhere. By sweep: Shamos & Hoey 1976, Theorem 7.
#include <sunder/planar/polygons/edge_contact_lists.h>
#include <sunder/planar/polygons/first_that_counts.h>
#include <sunder/planar/polygons/polygon_pairs.h>
#include <sunder/planar/polygons/polygon_sweep.h>

namespace sunder::planar {

PolygonsAnswer polygons_any(std::span<const Polygon> polygons, const SetOptions& options) {
  return polygons_any_by_boxes(polygons, options);
}

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

PolygonsAnswer polygons_any_by_grid(std::span<const Polygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  PolygonEdges edges(pointers_to(polygons));
  PolygonsAnswer answer;
  PolygonMeetings meetings(edges, options.groups, first_that_counts(answer, options.allowed));
  const bool own = options.allowed != Allowed::nothing || !options.groups.empty();
  const std::optional<bool> none_counts =
      take_contacts_by_grid(edges, {options.groups, own, options.progress}, meetings);
  if (!none_counts) return polygons_any_by_sweep(polygons, options);
  if (*none_counts && meetings.look_around_points()) meetings.look_inside();
  answer.cost = meetings.cost;
  classify(polygons, answer);
  return answer;
}

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
