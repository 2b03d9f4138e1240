#include <sunder/solid/descent/polar_proposals.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/represent/polar_hierarchy.h>

namespace sunder::solid {

PairAnswer polyhedron_polyhedron_by_polar(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                          const ConvexPolyhedron& body_b, const Pose& pose_b) {
  if (body_a.dimension() != 3 && body_b.dimension() != 3) {
    return polyhedron_polyhedron_by_hierarchy(body_a, pose_a, body_b, pose_b);
  }
  return polyhedron_polyhedron_by_trees<SectorTrees>(Placed(body_a, pose_a), Placed(body_b, pose_b));
}

PolarRun polyhedron_polyhedron_polar_run(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                         const ConvexPolyhedron& body_b, const Pose& pose_b) {
  PolarRun run;
  if (body_a.dimension() != 3 && body_b.dimension() != 3) return run;
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  const bool of_b = polar_of(a, b) == PolarOf::b;
  const Placed &p = of_b ? a : b, &r = of_b ? b : a;
  Cost cost;
  PolarWalk<double, SectorTrees>(p, r, cost, &run.rounds).run();
  run.levels_p = p.graph.vertices.size() < 3 ? 1 : represent::of<Hierarchy>(p.body).level_end.size();
  run.levels_q = represent::of<PolarHierarchy>(r.body).hierarchy.level_end.size();
  return run;
}

}  // namespace sunder::solid
