// bench_hull: how long does the exact hull take? Against Qhull, 100,000 random points on the sphere (all are vertices).
//
// Fairness: the same points, in one run, alternating; from points in memory to facets in memory, in process. Qhull gets
// its default options: `Q0` (no merging) and `Qt` (triangulated output) were measured to make no difference here.
// The time is the median over the rounds, in processor time of the thread (neither library starts others). Sunder's
// hull is exact; Qhull's is not.
#include <bench/contest/program.h>
#include <bench/inputs/body_scenarios.h>
#include <bench/peers/body_peer.h>

#include <sunder/solid/hull/convex_hull.h>

#include <memory>
#include <vector>

namespace bench {
namespace {

constexpr double kAllowed = 2;  // times Qhull's time, at kSize points
constexpr std::size_t kSize = 100000;

Contest contest(std::size_t n) {
  const auto points = std::make_shared<const std::vector<Vec>>(sphere_points(n, 7));
  auto same = std::make_shared<std::vector<sunder::Point3>>();
  for (const Vec& p : *points) same->push_back({p[0], p[1], p[2]});
  Contest made;
  made.truths = {n};
  made.subjects = {entry_by_input("sunder", "convex_hull", 1, [=](std::size_t) -> Asked {
    return [=] { return sunder::solid::convex_hull(*same).vertices.size(); };
  })};
  made.peers = {entry_by_input("qhull", "qh_new_qhull", 1,
                               [=](std::size_t) -> Asked { return [=] { return vertices_by_qhull(*points); }; })};
  return made;
}

std::vector<Plan> plans(const Options&) {
  const Demand demand{"qhull", {{kSize, 1 / kAllowed}}};
  return {{"points on a sphere", "hull", demand, {1000, 10000, kSize}, [](std::size_t n, std::uint64_t) {
             return contest(n);
           }}};
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_hull";
  program.note = "Wrong: hulls that have not all points as vertices.";
  program.libraries = {"qhull"};
  program.plans = bench::plans;
  return bench::run(program, argc, argv);
}
