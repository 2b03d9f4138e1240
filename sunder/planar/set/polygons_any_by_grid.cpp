#include <sunder/planar/set/edge_contact_lists.h>
#include <sunder/planar/set/first_that_counts.h>
#include <sunder/planar/set/polygons_any.h>

namespace sunder::planar {

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

}  // namespace sunder::planar
