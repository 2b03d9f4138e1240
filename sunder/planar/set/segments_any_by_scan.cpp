// The oracle: every pair.
#include <sunder/planar/set/segments_any.h>

namespace sunder::planar {

SegmentsAnswer segments_any_by_scan(const Segments& segments, const SegmentsOptions& options) {
  SegmentsAnswer answer;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    for (std::uint32_t j = i + 1; j < segments.size(); ++j) {
      ++answer.cost.probes;
      const ContactKind kind = segment_segment(segments[i], segments[j]);
      if (!counts(kind, options.allowed) || may_meet(options.groups, i, j)) continue;
      answer.found = contact_of(i, j, kind);
      return answer;
    }
  }
  return answer;
}

}  // namespace sunder::planar
