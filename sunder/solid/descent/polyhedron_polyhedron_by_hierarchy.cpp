// Two polyhedra by their hierarchies of Dobkin and Kirkpatrick.
#include <sunder/solid/descent/level_descent.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

namespace sunder::solid {

PairAnswer polyhedron_polyhedron_by_hierarchy(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                              const ConvexPolyhedron& b, const Pose& pose_b) {
  return polyhedron_polyhedron_by_levels<PlainLevels>(a, pose_a, b, pose_b);
}

}  // namespace sunder::solid
