// Does a mesh cross itself, and where? All pairs of triangles that have more in common than corners and edges of both.
// Also called: self-intersection; improper or degenerate mesh; mesh validation.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/solid/mesh/mesh.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace sunder::solid {

// Two triangles, the first of lower number.
struct CrossingTriangles {
  std::uint32_t first = 0, second = 0;

  friend auto operator<=>(const CrossingTriangles&, const CrossingTriangles&) = default;
};

//   S1. Two triangles cross if they have more in common than the corners and edges that they share
//       (predicate/line/triangle_contact.h); so do triangles with the same three corners.
//   S2. Of T-junctions, where an edge ends inside another one, and nothing else, is no crossing: such pairs are counted.
//   S3. Triangles without area cross nothing; they are counted.
struct [[nodiscard]] MeshCrossings {
  std::vector<CrossingTriangles> pairs;  // that cross, in their order
  bool are_all = true;                   // else as many as were asked for, and there are more
  std::uint64_t t_junctions = 0;         // pairs
  std::uint64_t without_area = 0;        // triangles
  Cost cost;  // probes: pairs of boxes and of triangles; exact: signs that were made in exact numbers
};

constexpr std::size_t all_crossings = std::numeric_limits<std::size_t>::max();

// Exact. Lists all pairs if there are no more than `most`; else it ends early, with `most` of them. Cost for n triangles: n,
// and the pairs of triangles whose boxes meet. Memory: some 200 bytes a triangle, and the pairs.
MeshCrossings mesh_crossings(const Mesh& mesh, std::size_t most = all_crossings);

// Each triangle with each.
MeshCrossings mesh_crossings_by_scan(const Mesh& mesh, std::size_t most = all_crossings);

}  // namespace sunder::solid
