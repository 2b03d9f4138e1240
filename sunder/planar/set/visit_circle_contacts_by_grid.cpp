// A grid finds the pairs that are near each other; where too many crowd in cells, the sweep lists the contacts of all
// of these, of which those are kept that a crowded cell is to look at.
#include <sunder/planar/set/circle_boxes.h>
#include <sunder/planar/set/circles_all.h>
#include <sunder/planar/set/near_pairs.h>

namespace sunder::planar {

Cost visit_circle_contacts_by_grid(const Circles& circles, const CirclesOptions& options,
                                   const CirclesContactVisitor& visit) {
  const std::vector<Segment> boxes = box_diagonals(circles);
  const std::optional<SegmentGrid> grid = SegmentGrid::over(boxes, 1);
  if (!grid || is_too_much(*grid, crowd_for_all, circles.size())) {
    return visit_circle_contacts_by_sweep(circles, options, visit);
  }
  Cost cost;
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    if (may_meet(options.groups, i, j)) return true;
    ++cost.probes;
    const DiscContact kind = circle_circle(circles[i], circles[j]);
    return !counts(kind, options.allowed) || visit({i, j, kind});
  };
  if (!for_each_near_pair<crowd_for_all>(boxes, *grid, of_pair, options.progress, &cost)) return cost;
  const std::vector<std::uint32_t> members = members_of_crowds(*grid, crowd_for_all, circles.size());
  if (members.empty()) return cost;
  const CirclesSubset part(circles, options.groups, members);
  const CirclesContactVisitor of_crowd = [&](const CirclesContact& contact) {
    const std::uint32_t i = members[contact.i], j = members[contact.j];
    const std::uint32_t c = grid->looking_cell(low_corner(boxes[i], boxes[j]));
    return grid->cell(c).size() <= crowd_for_all || visit({i, j, contact.kind});
  };
  cost.probes += visit_circle_contacts_by_sweep(part.circles, {options.allowed, part.groups}, of_crowd).probes;
  return cost;
}

}  // namespace sunder::planar
