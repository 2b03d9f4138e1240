#include <sunder/planar/pair/nearest_search.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_answer.h>

namespace sunder::planar {

PairAnswer polygon_polygon_by_gjk(const ConvexPolygon& a, const Pose& pose_a,  //
                                  const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b, [](const auto& in_a, const auto& in_b) {
    return answer_by(in_a, in_b, [&](const auto& holds, Cost& cost, StageTally&) {
      return propose_by_nearest(in_a, in_b, holds, cost);
    });
  });
}

}  // namespace sunder::planar
