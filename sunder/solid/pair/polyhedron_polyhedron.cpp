#include <sunder/solid/exact/exact_simplex.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

namespace sunder {

namespace solid {

PairAnswer polyhedron_polyhedron(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                 const ConvexPolyhedron& b, const Pose& pose_b) {
  return polyhedron_polyhedron_by_gjk(a, pose_a, b, pose_b);
}

Relation polyhedron_polyhedron_contact(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                       const ConvexPolyhedron& b, const Pose& pose_b) {
  const PairAnswer answer = polyhedron_polyhedron(a, pose_a, b, pose_b);
  const auto* common = std::get_if<CommonVertices>(&answer.evidence);
  if (common == nullptr) return Relation::none;
  // Five vertices whose weights are unique and positive span A - B around the origin.
  if (common->count_a + common->count_b == 5) return Relation::overlapping;
  StageTally tally;
  return interiors_meet(a, Placed(a, pose_a), b, Placed(b, pose_b), tally) ? Relation::overlapping : Relation::touching;
}

}  // namespace solid
}  // namespace sunder
