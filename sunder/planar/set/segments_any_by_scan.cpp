#include <sunder/planar/set/segments_all.h>

namespace sunder::planar {

SegmentsAnswer segments_any_by_scan(const Segments& segments, const SetOptions& options) {
  return {first_of<SegmentsContact>(
              [&](const SegmentsVisitor& visit) { return segments_all_by_scan(segments, options, visit); }),
          {}};
}

}  // namespace sunder::planar
