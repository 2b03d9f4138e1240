#include <sunder/near/set_methods.h>
#include <sunder/planar/set/segment_boxes.h>
#include <sunder/planar/set/segments_any.h>

namespace sunder::planar {

SegmentsAnswer segments_any_by_grid(const Segments& segments, const SetOptions& options) {
  if (options.transcript) return segments_any_by_sweep(segments, options);
  return {any_by_grid(segments, segments.all(), grid_over(segments), options, segments_any_by_sweep), {}};
}

}  // namespace sunder::planar
