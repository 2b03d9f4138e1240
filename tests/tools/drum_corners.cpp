// The drums of a body, for docs/images/plot_drums.py: a family of solid_shapes.h, cut along its z axis.
//
//   drum_corners FAMILY VERTICES SEED
// Prints a line for each drum, bottom up: its number of lateral edges, then x, y, z of each edge's corner on the lower
// slice and on the upper one, in cyclic order.
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/drums.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

using sunder::Point3;
using sunder::Random;
using sunder::solid::ConvexPolyhedron;
using sunder::solid::Drums;
using sunder::solid::LateralEdge;

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto shapes = sunder::tests::all_solid_shapes();
  const auto shape =
      std::find_if(shapes.begin(), shapes.end(), [&](const auto& s) { return s.name == std::string_view(argv[1]); });
  if (shape == shapes.end()) return 2;
  Random random(std::strtoull(argv[3], nullptr, 10));
  const ConvexPolyhedron body(shape->make(std::strtoull(argv[2], nullptr, 10), random));
  const Drums drums(body, {0, 0, 1}, sunder::solid::DrumsForm::persistent);
  const auto vertices = body.vertices();
  for (std::uint32_t d = 0; d < drums.drum_count(); ++d) {
    std::printf("%u", drums.size(d));
    for (std::uint32_t k = 0; k < drums.size(d); ++k) {
      const LateralEdge& e = drums.edge(d, k);
      const Point3 &p = vertices[e.low], &q = vertices[e.high];
      for (const std::uint32_t slice : {d, d + 1}) {
        const double z = vertices[drums.vertex_of(slice)].z, t = (z - p.z) / (q.z - p.z);
        std::printf("  %.6f %.6f %.6f", p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), z);
      }
    }
    std::printf("\n");
  }
}
