// The oracle: every pair.
#include <sunder/planar/set/segments_all.h>

namespace sunder::planar {

Cost visit_contacts_by_scan(const Segments& segments, const SegmentsOptions& options, const ContactVisitor& visit) {
  Cost cost;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    for (std::uint32_t j = i + 1; j < segments.size(); ++j) {
      ++cost.probes;
      const ContactKind kind = segment_segment(segments[i], segments[j]);
      if (!counts(kind, options.allowed) || may_meet(options.groups, i, j)) continue;
      if (!visit({i, j, kind})) return cost;
    }
  }
  return cost;
}

}  // namespace sunder::planar
