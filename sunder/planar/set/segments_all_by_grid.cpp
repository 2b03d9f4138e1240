#include <sunder/near/set_methods.h>
#include <sunder/planar/set/segment_boxes.h>
#include <sunder/planar/set/segments_all.h>

namespace sunder::planar {

Cost segments_all_by_grid(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  return visit_by_grid(segments, segments.all(), grid_over(segments), options, visit, segments_all_by_sweep);
}

}  // namespace sunder::planar
