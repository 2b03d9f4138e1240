#include <sunder/planar/pair/difference_search.h>
#include <sunder/planar/pair/polygon_polygon.h>

namespace sunder::planar {

PairAnswer polygon_polygon(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b) {
  return polygon_polygon_by_difference(a, pose_a, b, pose_b);
}

Contact polygon_polygon_contact(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b,
                                const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b,
                     [](const auto& in_a, const auto& in_b) { return contact_by_difference(in_a, in_b); });
}

}  // namespace sunder::planar
