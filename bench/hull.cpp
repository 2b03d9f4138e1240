// bench_hull: how long does the exact hull take? Against Qhull, up to 100,000 points: random ones on the sphere (all
// are vertices), and the families of tests/support/solid_shapes.h.
//
// Fairness: the same points, in one run, alternating; from points in memory to facets in memory, in process. Qhull gets
// its default options: `Q0` (no merging) and `Qt` (triangulated output) were measured to make no difference here.
// The time is the median over the rounds, in processor time of the thread (neither library starts others). Sunder's
// hull is exact; Qhull's is not.
#include <bench/contest/program.h>
#include <bench/peers/body_peer.h>

#include <tests/support/solid_shapes.h>

#include <sunder/solid/hull/convex_hull.h>

#include <memory>
#include <string>
#include <vector>

namespace bench {
namespace {

constexpr double kAllowed = 2;  // times Qhull's time, at kSize points
constexpr std::size_t kSize = 100000;

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
  }
  return plans;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_hull";
  program.note = "Wrong: hulls that have another number of vertices than the family has.";
  program.libraries = {"qhull"};
  program.plans = bench::plans;
  return bench::run(program, argc, argv);
}
