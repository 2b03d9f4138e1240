#include <sunder/planar/pair/cone_search.h>
#include <sunder/planar/pair/difference_search.h>
#include <sunder/planar/pair/polygon_polygon.h>

namespace sunder::planar {

PairAnswer polygon_polygon(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b, [](const auto& in_a, const auto& in_b) {
    PairAnswer answer;
    StageTally tally;
    const bool flat = in_a.size() < 3 || in_b.size() < 3;
    if (flat || !search_cone(in_a, in_b, answer.evidence, answer.cost, tally)) {
      answer.evidence = {};
      search_difference(in_a, 0, in_b, 0, answer.evidence, answer.cost, tally);
    }
    answer.cost.exact = tally.exact;
    answer.decided_by = tally.exact == 0 ? DecidedBy::filter : DecidedBy::evidence;
    return answer;
  });
}

Contact polygon_polygon_contact(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b,
                                const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b,
                     [](const auto& in_a, const auto& in_b) { return contact_by_difference(in_a, in_b); });
}

}  // namespace sunder::planar
