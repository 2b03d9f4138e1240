#include <sunder/planar/set/segments_any.h>

namespace sunder::planar {

SegmentsAnswer segments_any(const Segments& segments, const SetOptions& options) {
  return segments_any_by_grid(segments, options);
}

}  // namespace sunder::planar
