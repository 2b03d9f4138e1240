// A grid finds the pairs that are near each other; where too many crowd in a cell, the sweep lists that cell's
// contacts, of which those are kept that the cell is to look at.
#include <sunder/planar/set/near_pairs.h>
#include <sunder/planar/set/segments_all.h>

namespace sunder::planar {

namespace {

constexpr std::uint32_t few = 128;  // of so many, all pairs are tested faster than any order is made

}  // namespace

Cost visit_contacts_by_grid(const Segments& segments, const SegmentsOptions& options, const ContactVisitor& visit) {
  const std::optional<SegmentGrid> grid = SegmentGrid::over(segments.all());
  if (!grid || crowded(*grid, crowd_for_all) > segments.size() / 2) {
    if (segments.size() <= few) return visit_contacts_by_scan(segments, options, visit);
    return visit_contacts_by_bentley_ottmann(segments, options, visit);
  }
  Cost cost;
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    if (may_meet(options.groups, i, j)) return true;
    ++cost.probes;
    const ContactKind kind = segment_segment(segments[i], segments[j]);
    return !counts(kind, options.allowed) || visit({i, j, kind});
  };
  const auto of_crowd = [&](std::uint32_t c) {
    const auto cell = grid->cell(c);
    const Part part(segments, options.groups, cell);
    bool goes_on = true;
    const Cost of_part = visit_contacts_by_bentley_ottmann(
        part.segments, {options.allowed, false, part.groups}, [&](const SegmentsContact& contact) {
          const std::uint32_t i = cell[contact.i], j = cell[contact.j];
          if (!grid->looks_at(c, low_corner(segments[i], segments[j]))) return true;
          return goes_on = visit({i, j, contact.kind});
        });
    cost.probes += of_part.probes;
    return goes_on;
  };
  for_each_near_pair<crowd_for_all>(segments.all(), *grid, of_pair, of_crowd, options.progress);
  return cost;
}

}  // namespace sunder::planar
