// The front doors, and the methods that all sets share.
#include <sunder/near/set_methods.h>
#include <sunder/planar/segments/segment_boxes.h>
#include <sunder/planar/segments/segments_all.h>

#include <algorithm>
#include <functional>

namespace sunder::planar {

Cost segments_visit(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  return segments_all_by_grid(segments, options, visit);
}

Cost segments_visit_block(const Segments& segments, const SetOptions& options, const Block& block, SegmentsMethod* by,
                          const SegmentsVisitor& visit) {
  return visit_of_block(segments, std::mem_fn(&Segments::all), options, block, by, visit);
}

namespace {

Cost visit_all(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit,
               SweepEvents& transcript) {
  return options.transcript ? segments_visit_with_transcript(segments, options, visit, transcript)
                            : segments_visit(segments, options, visit);
}

}  // namespace

SegmentsAllAnswer segments_all(const Segments& segments, const SetOptions& options) {
  SegmentsAllAnswer answer;
  static_cast<AllAnswer<SegmentsContact>&>(answer) = all_of<SegmentsContact>(
      [&](const SegmentsVisitor& visit) { return visit_all(segments, options, visit, answer.transcript); });
  if (options.transcript) std::sort(answer.contacts.begin(), answer.contacts.end());
  return answer;
}

SegmentsCountAnswer segments_count(const Segments& segments, const SetOptions& options) {
  SegmentsCountAnswer answer;
  static_cast<CountAnswer&>(answer) = count_of<SegmentsContact>(
      [&](const SegmentsVisitor& visit) { return visit_all(segments, options, visit, answer.transcript); });
  return answer;
}

Cost segments_all_by_grid(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  return visit_by_grid(segments, segments.all(), grid_over(segments), options, visit, segments_all_by_sweep);
}

Cost segments_all_by_scan(const Segments& segments, const SetOptions& options, const SegmentsVisitor& visit) {
  return visit_by_scan(segments, options, visit);
}

}  // namespace sunder::planar
