// One run of the walk between two spaces, for docs/images/plot_polar_run.py: two bodies of a family of solid_shapes.h,
// near contact, apart by a gap or, with a negative one, overlapping.
//
//   polar_run FAMILY VERTICES GAP SEED
// Prints: the levels of both hierarchies, the answer; then a line for each round: space, what held after it, the levels
// reached, and the plane's normal or the point.
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/descent/polar_round.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

using sunder::Random;
using sunder::solid::ConvexPolyhedron;
using sunder::solid::PolarRound;
using sunder::solid::Pose;

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const auto shapes = sunder::tests::all_solid_shapes();
  const auto shape =
      std::find_if(shapes.begin(), shapes.end(), [&](const auto& s) { return s.name == std::string_view(argv[1]); });
  if (shape == shapes.end()) return 2;
  Random random(std::strtoull(argv[4], nullptr, 10));
  const ConvexPolyhedron body(shape->make(std::strtoull(argv[2], nullptr, 10), random));
  std::array<double, 4> q;
  for (double& x : q) x = random.uniform(-1, 1);
  const Pose here, turned = Pose::from_quaternion(q[0], q[1], q[2], q[3], {});
  const sunder::Point3 way = sunder::tests::on_sphere(random);
  const auto at = [&](double far) {
    return Pose::from_matrix(turned.affine().linear, {way.x * far, way.y * far, way.z * far});
  };
  double meeting = 0, parted = 8;
  for (int i = 0; i < 60; ++i) {
    const double middle = (meeting + parted) / 2;
    (polyhedron_polyhedron(body, here, body, at(middle)).meet() ? meeting : parted) = middle;
  }
  const Pose there = at(parted + std::strtod(argv[3], nullptr));
  const auto run = polyhedron_polyhedron_polar_run(body, here, body, there);
  std::printf("levels %zu %zu %s\n", run.levels_p, run.levels_q,
              polyhedron_polyhedron_by_polar(body, here, body, there).meet() ? "meet" : "apart");
  constexpr std::array spaces{"top", "primal", "polar"};
  for (const PolarRound& r : run.rounds) {
    std::printf("%-6s %-5s %2zu %2zu  %.17g %.17g %.17g\n", spaces[static_cast<std::size_t>(r.space)],
                r.is_apart ? "plane" : "point", r.level_p, r.level_q, r.at.x, r.at.y, r.at.z);
  }
}
