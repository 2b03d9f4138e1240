// A grid finds the pairs whose boxes meet; where too many crowd in cells, a sweep decides about all of these.
#include <sunder/planar/set/box_pairs.h>
#include <sunder/planar/set/convex_pair_test.h>

namespace sunder::planar {

ConvexPolygonsAnswer convex_polygons_any_by_grid(std::span<const ConvexPolygon> polygons,
                                                 const ConvexPolygonsOptions& options) {
  if (options.transcript && options.groups.empty()) return convex_polygons_any_by_sweep(polygons, options);
  ConvexPolygonsAnswer answer;
  const auto& [boxes, diagonals] = extents_of(polygons);
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    if (may_meet(options.groups, i, j)) return true;
    ++answer.cost.probes;
    if (surely_apart(diagonals[i], diagonals[j])) return true;
    return !report_pair(polygons, i, j, options.allowed, answer);
  };
  if (!options.groups.empty()) {
    for_each_box_pair(boxes, of_pair, options.progress);
    return answer;
  }
  const std::optional<BoxGrid> grid = BoxGrid::over(boxes);
  if (!grid || grid->crowded(crowd_of_boxes) > polygons.size() / 2) {
    return convex_polygons_any_by_sweep(polygons, options);
  }
  if (!for_each_near_box_pair(boxes, *grid, crowd_of_boxes, of_pair, options.progress)) return answer;
  const std::vector<std::uint32_t> members = grid->members_of_crowds(crowd_of_boxes);
  if (members.empty()) return answer;
  std::vector<ConvexPolygon> crowd;
  crowd.reserve(members.size());
  for (const std::uint32_t i : members) crowd.push_back(polygons[i]);
  ConvexPolygonsAnswer in_crowd = convex_polygons_any_by_sweep(crowd, {options.allowed, false, {}, nullptr});
  in_crowd.cost.probes += answer.cost.probes;
  in_crowd.i = members[in_crowd.i];  // also of `none`, where it is meaningless
  in_crowd.j = members[in_crowd.j];
  return in_crowd;
}

}  // namespace sunder::planar
