// A grid finds the pairs that are near each other; where too many crowd in cells, another method lists the
// contacts of all of these, of which those are kept that a crowded cell is to look at.
#include <sunder/planar/set/near_pairs.h>
#include <sunder/planar/set/segments_all.h>

namespace sunder::planar {

Cost visit_contacts_by_grid(const Segments& segments, const SegmentsOptions& options, const ContactVisitor& visit) {
  const std::optional<SegmentGrid> grid = SegmentGrid::over(segments);
  if (!grid || is_too_much(*grid, crowd_for_all, segments.size())) {
    return visit_contacts_by_sweep(segments, options, visit);
  }
  Cost cost;
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    if (may_meet(options.groups, i, j)) return true;
    ++cost.probes;
    const ContactKind kind = segment_segment(segments[i], segments[j]);
    return !counts(kind, options.allowed) || visit({i, j, kind});
  };
  if (!for_each_near_pair<crowd_for_all>(segments.all(), *grid, of_pair, options.progress, &cost)) return cost;
  const std::vector<std::uint32_t> members = members_of_crowds(*grid, crowd_for_all, segments.size());
  if (members.empty()) return cost;
  const Part part(segments, options.groups, members);
  const ContactVisitor of_crowd = [&](const SegmentsContact& contact) {
    const std::uint32_t i = members[contact.i], j = members[contact.j];
    const std::uint32_t c = grid->looking_cell(low_corner(segments[i], segments[j]));
    return grid->cell(c).size() <= crowd_for_all || visit({i, j, contact.kind});
  };
  cost.probes += visit_contacts_by_sweep(part.segments, {options.allowed, false, part.groups}, of_crowd).probes;
  return cost;
}

}  // namespace sunder::planar
