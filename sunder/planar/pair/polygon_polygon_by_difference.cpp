#include <sunder/planar/pair/difference_search.h>
#include <sunder/planar/pair/polygon_polygon.h>

namespace sunder::planar {

PairAnswer polygon_polygon_by_difference(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b, [](const auto& in_a, const auto& in_b) {
    PairAnswer answer;
    StageTally tally;
    search_difference(in_a, 0, in_b, 0, answer.evidence, answer.cost, tally);
    answer.cost.exact = tally.exact;
    answer.decided_by = tally.exact == 0 ? DecidedBy::filter : DecidedBy::evidence;
    return answer;
  });
}

}  // namespace sunder::planar
