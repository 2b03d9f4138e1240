#include <sunder/planar/pair/difference_search.h>
#include <sunder/planar/pair/halving.h>
#include <sunder/planar/pair/polygon_polygon.h>

namespace sunder::planar {

PairAnswer polygon_polygon_by_halving(const ConvexPolygon& a, const Pose& pose_a,  //
                                      const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b, [](const auto& in_a, const auto& in_b) {
    PairAnswer answer;
    StageTally tally;
    const bool flat = in_a.size() < 3 || in_b.size() < 3;
    const bool found = !flat && search_by_halving(in_a, in_b, answer.evidence, answer.cost, tally);
    if (!found) search_difference(in_a, 0, in_b, 0, answer.evidence, answer.cost, tally);
    answer.cost.exact = tally.exact;
    answer.decided_by = !found && !flat    ? DecidedBy::finishing
                        : tally.exact == 0 ? DecidedBy::filter
                                           : DecidedBy::evidence;
    return answer;
  });
}

}  // namespace sunder::planar
