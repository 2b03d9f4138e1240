// The front door, and the methods of which all but what they propose is polygon_polygon_answer.h.
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_by.h>

namespace sunder::planar {

PairAnswer polygon_polygon(const ConvexPolygon& a, const Pose& pose_a,  //
                           const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b,
                     [](const auto& in_a, const auto& in_b) { return answer_by_cone(in_a, in_b); });
}

PairAnswer polygon_polygon_by_difference(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b,
                     [](const auto& in_a, const auto& in_b) { return answer_exactly(in_a, in_b); });
}

PairAnswer polygon_polygon_by_halving(const ConvexPolygon& a, const Pose& pose_a,  //
                                      const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b,
                     [](const auto& in_a, const auto& in_b) { return answer_by_halving(in_a, in_b); });
}

PairAnswer polygon_polygon_by_gjk(const ConvexPolygon& a, const Pose& pose_a,  //
                                  const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b,
                     [](const auto& in_a, const auto& in_b) { return answer_by_nearest(in_a, in_b); });
}

Relation polygon_polygon_contact(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b,
                                 const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b,
                     [](const auto& in_a, const auto& in_b) { return contact_by_difference(in_a, in_b); });
}

}  // namespace sunder::planar
