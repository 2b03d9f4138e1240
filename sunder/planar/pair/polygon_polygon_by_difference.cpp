#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_answer.h>

namespace sunder::planar {

PairAnswer polygon_polygon_by_difference(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b,
                     [](const auto& in_a, const auto& in_b) { return answer_exactly(in_a, in_b); });
}

}  // namespace sunder::planar
