#include <sunder/planar/set/segments_all.h>
#include <sunder/planar/set/segments_any.h>

namespace sunder::planar {

SegmentsAnswer segments_any(const Segments& segments, const SegmentsOptions& options) {
  return segments_any_by_grid(segments, options);
}

SegmentsAnswer segments_any_by_bentley_ottmann(const Segments& segments, const SegmentsOptions& options) {
  SegmentsAnswer answer;
  answer.cost = visit_contacts_by_bentley_ottmann(segments, options, [&](const SegmentsContact& contact) {
    answer.kind = contact.kind;
    answer.i = contact.i;
    answer.j = contact.j;
    return false;
  });
  return answer;
}

}  // namespace sunder::planar
