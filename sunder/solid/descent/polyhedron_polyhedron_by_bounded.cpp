// Two polyhedra by their bounded hierarchies: the walk between two spaces, or where both are flat, their closest
// points.
#include <sunder/solid/descent/level_descent.h>
#include <sunder/solid/descent/polar_proposals.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

namespace sunder::solid {

PairAnswer polyhedron_polyhedron_by_bounded(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                            const ConvexPolyhedron& body_b, const Pose& pose_b) {
  if (body_a.dimension() != 3 && body_b.dimension() != 3) {
    return polyhedron_polyhedron_by_levels<BoundedLevels>(body_a, pose_a, body_b, pose_b);
  }
  Placed a(body_a, pose_a), b(body_b, pose_b);
  a.by_bounded = b.by_bounded = true;
  return polyhedron_polyhedron_by_trees<BoundedTrees>(a, b);
}

}  // namespace sunder::solid
