// The front doors, and the methods that all sets share.
#include <sunder/near/set_methods.h>
#include <sunder/planar/segments/segment_boxes.h>
#include <sunder/planar/segments/segments_all.h>

#include <functional>

namespace sunder::planar {

Cost segments_visit(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  return segments_all_by_grid(segments, options, visit);
}

Cost segments_visit_block(const Segments& segments, const SetOptions& options, const Block& block, SegmentsMethod* by,
                          const SegmentsVisitor& visit) {
  return visit_of_block(segments, std::mem_fn(&Segments::all), options, block, by, visit);
}

SegmentsAllAnswer segments_all(const Segments& segments, const SetOptions& options) {
  return all_of<SegmentsContact>(
      [&](const SegmentsVisitor& visit) { return segments_visit(segments, options, visit); });
}

CountAnswer<> segments_count(const Segments& segments, const SetOptions& options) {
  return count_of<SegmentsContact>(
      [&](const SegmentsVisitor& visit) { return segments_visit(segments, options, visit); });
}

Cost segments_all_by_grid(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  return visit_by_grid(segments, segments.all(), grid_over(segments), options, visit, segments_all_by_sweep);
}

Cost segments_all_by_scan(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  return visit_by_scan(segments, options, visit);
}

}  // namespace sunder::planar
