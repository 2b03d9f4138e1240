// A grid finds the pairs whose boxes meet; where too many crowd in cells, a sweep decides about all of these.
//
// Members of one group may overlap, and neighbours on that sweep's line tell nothing then. Where boxes are too many,
// the sweep decides that takes polygons of any shape, and passes crossings.
#include <sunder/near/box_pairs.h>
#include <sunder/planar/polygons/convex_pair_test.h>
#include <sunder/planar/polygons/first_that_counts.h>
#include <sunder/planar/polygons/polygon_sweep.h>

#include <limits>

namespace sunder::planar {

namespace {

// Requires that no polygon is a point or a segment.
void take_any_by_sweep(std::span<const ConvexPolygon> polygons, const SetOptions& options,
                       ConvexPolygonsAnswer& answer) {
  std::vector<Polygon> of_any_shape;
  of_any_shape.reserve(polygons.size());
  for (const ConvexPolygon& polygon : polygons) {
    const std::vector<Point2> ring(polygon.vertices().begin(), polygon.vertices().end());
    of_any_shape.emplace_back(std::span(&ring, 1));
  }
  const PolygonEdges edges(pointers_to(of_any_shape));
  const Allowed allowed = options.allowed == Allowed::touch ? Allowed::touch : Allowed::nothing;
  PolygonsAnswer some;
  PolygonSweep sweep(edges, {allowed, options.groups, options.progress}, first_that_counts(some, allowed));
  sweep.run();
  answer.cost.probes += sweep.cost.probes;
  if (some.meet()) report_pair(polygons, some.found->i, some.found->j, allowed, answer);
}

ConvexPolygonsAnswer any_across_groups(std::span<const ConvexPolygon> polygons, const SetOptions& options) {
  constexpr std::uint64_t looks = 64;  // for each vertex
  std::uint64_t most = 0;
  bool some_are_flat = false;
  for (const ConvexPolygon& polygon : polygons) {
    most += looks * polygon.size();
    some_are_flat |= polygon.size() < 3;
  }
  if (some_are_flat) most = std::numeric_limits<std::uint64_t>::max();
  ConvexPolygonsAnswer answer;
  const auto& [boxes, diagonals] = extents_of(polygons);
  std::uint64_t in_boxes = 0;
  const bool all = for_each_box_pair(
      boxes,
      [&](std::uint32_t i, std::uint32_t j) {
        ++answer.cost.probes;
        const bool are_apart = surely_apart(diagonals[i], diagonals[j]);
        return (are_apart || !report_pair(polygons, i, j, options.allowed, answer)) && answer.cost.probes <= most;
      },
      options.progress, &in_boxes, options.groups);
  answer.cost.probes += in_boxes;
  if (!all && !answer.meet()) take_any_by_sweep(polygons, options, answer);
  return answer;
}

}  // namespace

ConvexPolygonsAnswer convex_polygons_any(std::span<const ConvexPolygon> polygons, const SetOptions& options) {
  return convex_polygons_any_by_grid(polygons, options);
}

ConvexPolygonsAnswer convex_polygons_any_by_grid(std::span<const ConvexPolygon> polygons, const SetOptions& options) {
  check_groups(options.groups, polygons.size());
  if (!options.groups.empty()) return any_across_groups(polygons, options);
  ConvexPolygonsAnswer answer;
  const auto& [boxes, diagonals] = extents_of(polygons);
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    ++answer.cost.probes;
    if (surely_apart(diagonals[i], diagonals[j])) return true;
    return !report_pair(polygons, i, j, options.allowed, answer);
  };
  const std::optional<BoxGrid> grid = BoxGrid::over(boxes);
  if (!grid || crowded(*grid, crowd_of_polygons) > polygons.size() / 2) {
    return convex_polygons_any_by_sweep(polygons, options);
  }
  if (!for_each_near_pair<crowd_of_polygons>(std::span<const Box2>(boxes), *grid, of_pair, options.progress))
    return answer;
  const std::vector<std::uint32_t> members = members_of_crowds(*grid, crowd_of_polygons, polygons.size());
  if (members.empty()) return answer;
  std::vector<ConvexPolygon> crowd;
  crowd.reserve(members.size());
  for (const std::uint32_t i : members) crowd.push_back(polygons[i]);
  ConvexPolygonsAnswer in_crowd = convex_polygons_any_by_sweep(crowd, {options.allowed, {}, nullptr});
  in_crowd.cost.probes += answer.cost.probes;
  if (in_crowd.meet()) {
    in_crowd.found->i = members[in_crowd.found->i];
    in_crowd.found->j = members[in_crowd.found->j];
  }
  return in_crowd;
}

}  // namespace sunder::planar
