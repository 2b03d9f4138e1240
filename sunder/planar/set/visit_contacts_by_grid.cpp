// A grid finds the pairs that are near each other; where too many crowd in cells, another method lists the
// contacts of all of these, of which those are kept that a crowded cell is to look at.
#include <sunder/base/random.h>
#include <sunder/planar/set/near_pairs.h>
#include <sunder/planar/set/segments_all.h>

namespace sunder::planar {

namespace {

constexpr std::uint32_t few = 128;  // of so many, all pairs are tested faster than any order is made
constexpr std::uint32_t many = 16;  // hits among N pairs by chance: k is about N times half of that

// Is k much larger than N? By a sample, always the same one.
bool many_meet(const Segments& segments) {
  Random random(1);
  std::uint32_t hits = 0;
  for (std::uint32_t k = 0; k < segments.size() && hits < many; ++k) {
    const std::uint32_t i = static_cast<std::uint32_t>(random.below(segments.size()));
    const std::uint32_t j = static_cast<std::uint32_t>(random.below(segments.size()));
    hits += i != j && segment_segment(segments[i], segments[j]) != ContactKind::none;
  }
  return hits == many;
}

Cost visit_contacts_without_grid(const Segments& segments, const SegmentsOptions& options,
                                 const ContactVisitor& visit) {
  if (segments.size() <= few) return visit_contacts_by_scan(segments, options, visit);
  if (many_meet(segments)) return visit_contacts_by_balaban(segments, options, visit);
  return visit_contacts_by_bentley_ottmann(segments, options, visit);
}

}  // namespace

Cost visit_contacts_by_grid(const Segments& segments, const SegmentsOptions& options, const ContactVisitor& visit) {
  const std::optional<SegmentGrid> grid = SegmentGrid::over(segments.all());
  if (!grid || crowded(*grid, crowd_for_all) > segments.size() / 2) {
    return visit_contacts_without_grid(segments, options, visit);
  }
  Cost cost;
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    if (may_meet(options.groups, i, j)) return true;
    ++cost.probes;
    const ContactKind kind = segment_segment(segments[i], segments[j]);
    return !counts(kind, options.allowed) || visit({i, j, kind});
  };
  if (!for_each_near_pair<crowd_for_all>(segments.all(), *grid, of_pair, options.progress)) return cost;
  const std::vector<std::uint32_t> members = members_of_crowds(*grid, crowd_for_all, segments.size());
  if (members.empty()) return cost;
  const Part part(segments, options.groups, members);
  const ContactVisitor of_crowd = [&](const SegmentsContact& contact) {
    const std::uint32_t i = members[contact.i], j = members[contact.j];
    const std::uint32_t c = grid->looking_cell(low_corner(segments[i], segments[j]));
    return grid->cell(c).size() <= crowd_for_all || visit({i, j, contact.kind});
  };
  cost.probes += visit_contacts_without_grid(part.segments, {options.allowed, false, part.groups}, of_crowd).probes;
  return cost;
}

}  // namespace sunder::planar
