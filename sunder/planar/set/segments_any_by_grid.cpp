// A grid finds the pairs that are near each other; where too many crowd in cells, a sweep decides about all of these.
#include <sunder/planar/set/near_pairs.h>
#include <sunder/planar/set/segments_any.h>

namespace sunder::planar {

SegmentsAnswer segments_any_by_grid(const Segments& segments, const SegmentsOptions& options) {
  const std::optional<SegmentGrid> grid = SegmentGrid::over(segments);
  if (!grid || options.transcript || is_too_much(*grid, crowd_for_any, segments.size())) {
    return segments_any_by_sweep(segments, options);
  }
  SegmentsAnswer answer;
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    if (may_meet(options.groups, i, j)) return true;
    ++answer.cost.probes;
    const ContactKind kind = segment_segment(segments[i], segments[j]);
    if (!counts(kind, options.allowed)) return true;
    answer.found = contact_of(i, j, kind);
    return false;
  };
  if (!for_each_near_pair<crowd_for_any>(segments.all(), *grid, of_pair, options.progress, &answer.cost)) return answer;
  if (crowded(*grid, crowd_for_any) == 0) return answer;
  const std::vector<std::uint32_t> members = members_of_crowds(*grid, crowd_for_any, segments.size());
  const Part part(segments, options.groups, members);
  const SegmentsAnswer in_crowd = segments_any_by_sweep(part.segments, {options.allowed, false, part.groups});
  answer.cost.probes += in_crowd.cost.probes;
  if (!in_crowd.meet()) return answer;
  answer.found = contact_of(members[in_crowd.found->i], members[in_crowd.found->j], in_crowd.found->kind);
  return answer;
}

}  // namespace sunder::planar
