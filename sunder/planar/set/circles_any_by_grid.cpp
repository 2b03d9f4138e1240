// A grid finds the pairs that are near each other; where too many crowd in cells, a sweep decides about all of these.
#include <sunder/planar/set/circle_boxes.h>
#include <sunder/planar/set/circles_any.h>
#include <sunder/planar/set/near_pairs.h>

namespace sunder::planar {

CirclesAnswer circles_any_by_grid(const Circles& circles, const CirclesOptions& options) {
  const std::vector<Segment> boxes = box_diagonals(circles);
  const std::optional<SegmentGrid> grid = SegmentGrid::over(boxes, 1);
  if (!grid || is_too_much(*grid, crowd_for_any, circles.size())) return circles_any_by_sweep(circles, options);
  CirclesAnswer answer;
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    if (may_meet(options.groups, i, j)) return true;
    ++answer.cost.probes;
    const DiscContact kind = circle_circle(circles[i], circles[j]);
    if (!counts(kind, options.allowed)) return true;
    answer.found = contact_of(i, j, kind);
    return false;
  };
  if (!for_each_near_pair<crowd_for_any>(boxes, *grid, of_pair, options.progress, &answer.cost)) return answer;
  const std::vector<std::uint32_t> members = members_of_crowds(*grid, crowd_for_any, circles.size());
  if (members.empty()) return answer;
  const CirclesSubset part(circles, options.groups, members);
  const CirclesAnswer in_crowd = circles_any_by_sweep(part.circles, {options.allowed, part.groups});
  answer.cost.probes += in_crowd.cost.probes;
  if (!in_crowd.meet()) return answer;
  answer.found = contact_of(members[in_crowd.found->i], members[in_crowd.found->j], in_crowd.found->kind);
  return answer;
}

}  // namespace sunder::planar
