// bench_hull: how long does the exact hull take? Against Qhull, up to 100,000 points: random ones on the sphere (all
// are vertices), and the families of tests/support/solid_shapes.h. And how long do the hierarchies over it take, of the
// body and of its polar? Against the hull itself.
//
// Fairness: the same points, in one run, alternating; from points in memory to facets in memory, in process. Qhull gets
// its default options: `Q0` (no merging) and `Qt` (triangulated output) were measured to make no difference here.
// The time is the median over the rounds, in processor time of the thread (neither library starts others). Sunder's
// hull is exact; Qhull's is not.
#include <bench/contest/program.h>
#include <bench/peers/body_peer.h>

#include <tests/support/solid_shapes.h>

#include <sunder/solid/hull/convex_hull.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/polar_hierarchy.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bench {
namespace {

constexpr double kAllowed = 2;  // times Qhull's time, at kSize points
constexpr std::size_t kSize = 100000;

// Times the hull's time, a hierarchy at kSize points. The polar has a vertex for each facet, up to two a point; and
// where hulls are quick (1.2 microseconds a point), taking a vertex away and filling the hole, exactly, is not quicker.
constexpr double kHierarchy = 1, kPolar = 3;

Contest contest(const std::vector<sunder::Point3>& given, std::size_t vertex_count, bool with_qhull) {
  const auto same = std::make_shared<const std::vector<sunder::Point3>>(given);
  auto points = std::make_shared<std::vector<Vec>>();
  for (const sunder::Point3& p : given) points->push_back({p.x, p.y, p.z});
  Contest made;
  made.truths = {vertex_count};
  made.wrong_peers_count = true;  // Qhull merges what is nearly coplanar, and loses vertices so
  made.subjects = {entry_by_input("sunder", "convex_hull", 1, [=](std::size_t) -> Asked {
    return [=] { return sunder::solid::convex_hull(*same).vertices.size(); };
  })};
  made.peers = {entry_by_input("qhull", "qh_new_qhull", 1, [=](std::size_t) -> Asked {
    if (!with_qhull) return {};
    return [=] { return vertices_by_qhull(*points); };
  })};
  return made;
}

// Of the body's vertices, or of its facets, as points of the polar.
Contest hierarchy_contest(const std::vector<sunder::Point3>& given, bool of_polar) {
  using namespace sunder::solid;
  const auto same = std::make_shared<const std::vector<sunder::Point3>>(given);
  const ConvexPolyhedron body(given);
  Contest made;
  made.truths = {of_polar ? body.facet_count() : body.vertices().size()};
  made.subjects = {entry_by_input("sunder", of_polar ? "polar hierarchy" : "hierarchy", 1, [=](std::size_t) -> Asked {
    if (of_polar) return [=] { return PolarHierarchy::make(body).hierarchy.nodes.size(); };
    return [=] { return Hierarchy::make(body).nodes.size(); };
  })};
  made.peers = {entry_by_input("hull", "ConvexPolyhedron", 1, [=](std::size_t) -> Asked {
    return [=]() -> std::uint64_t {
      const ConvexPolyhedron hull(*same);
      return of_polar ? hull.facet_count() : hull.vertices().size();
    };
  })};
  return made;
}

std::vector<Plan> plans(const Options&) {
  const Demand demand{"qhull", {{kSize, 1 / kAllowed}}};
  const std::vector<std::size_t> sizes{1000, 10000, kSize};
  std::vector<Plan> plans;
  for (const sunder::tests::SolidShape& shape : sunder::tests::all_solid_shapes()) {
    const bool sphere = shape.name == "sphere";
    // Qhull has no hull of what is flat, and its numbers do not reach across a needle.
    const bool with_qhull = shape.name != "flat" && shape.name != "needle";
    plans.push_back({sphere ? "points on a sphere" : std::string(shape.name), "hull", with_qhull ? demand : Demand{},
                     sizes, [=](std::size_t n, std::uint64_t seed) {
                       sunder::Random random(seed);
                       return contest(shape.make(n, random), shape.vertex_count(n), with_qhull);
                     }});
    for (const bool of_polar : {false, true}) {
      // The flat have no polar; coordinates of a needle go through exact numbers, in hull and hierarchy alike.
      if (shape.name == "flat" || shape.name == "needle") continue;
      const Demand of_hull{"hull", {{kSize, 1 / (of_polar ? kPolar : kHierarchy)}}};
      plans.push_back({sphere ? "points on a sphere" : std::string(shape.name), of_polar ? "polar" : "hierarchy",
                       of_hull, sizes, [=](std::size_t n, std::uint64_t seed) {
                         sunder::Random random(seed);
                         return hierarchy_contest(shape.make(n, random), of_polar);
                       }});
    }
  }
  return plans;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_hull";
  program.note = "Wrong: hulls that have another number of vertices than the family has.";
  program.libraries = {"qhull", "hull"};
  program.questions = {"hull", "hierarchy", "polar"};
  program.plans = bench::plans;
  return bench::run(program, argc, argv);
}
