// The front door, and the methods that all sets share.
#include <sunder/near/set_methods.h>
#include <sunder/planar/segments/segment_boxes.h>
#include <sunder/planar/segments/segments_all.h>

namespace sunder::planar {

SegmentsAnswer segments_any(const Segments& segments, const SetOptions& options) {
  return segments_any_by_grid(segments, options);
}

SegmentsAnswer segments_any_by_grid(const Segments& segments, const SetOptions& options) {
  return any_by_grid(segments, segments.all(), grid_over(segments), options, segments_any_by_sweep);
}

SegmentsAnswer segments_any_by_scan(const Segments& segments, const SetOptions& options) {
  return first_of<SegmentsContact>(
      [&](const SegmentsVisitor& visit) { return segments_all_by_scan(segments, options, visit); });
}

}  // namespace sunder::planar
