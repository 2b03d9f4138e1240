// The oracle: every pair.
#include <sunder/near/set_methods.h>
#include <sunder/planar/set/segments_all.h>

namespace sunder::planar {

Cost segments_all_by_scan(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  return visit_by_scan(segments, options, visit);
}

}  // namespace sunder::planar
