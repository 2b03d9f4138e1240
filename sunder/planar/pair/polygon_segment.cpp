#include <sunder/planar/pair/cut_by_scan.h>
#include <sunder/planar/pair/line_search.h>
#include <sunder/planar/pair/polygon_segment.h>

namespace sunder::planar {

PolygonCut polygon_segment(const ConvexPolygon& polygon, const Pose& pose, const Segment& segment) {
  if (segment.a != segment.b) return cut_and_clip(polygon, pose, segment.a, segment.b, true);
  const PolygonPoint at = polygon_point(polygon, pose, segment.a);
  PolygonCut answer{BeyondEnd{OwnEnd::a}, at.decided_by, at.cost};
  if (const std::optional<CutEnd> end = end_at(at, OwnEnd::a)) answer.evidence = CutPoint{*end};
  return answer;
}

PolygonCut polygon_segment_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Segment& segment) {
  return cut_by_scan(polygon, pose, segment.a, segment.b, {.a = true, .b = true});
}

}  // namespace sunder::planar
