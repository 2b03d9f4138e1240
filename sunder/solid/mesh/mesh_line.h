// Where does a line, a ray or a segment meet a mesh, as it is? The answer lists all common points in order, so it begins
// with the first hit.
// Also called: ray casting, ray-mesh intersection, ray shooting; entry and exit points; pick ray.
//
// The mesh is the solid that its closed pieces bound, and the surface of its open ones (mesh.h). The line runs from its
// point a through its point b; so do the ray, from a on, and the segment, from a to b.
//   L1. A *hit* is what a triangle has of the line: its points a + t (b - a), t from `first` to `last`, which are equal
//       where the line goes across the triangle. Exact.
//   L2. A *part* is an interval of t that is in the mesh; parts are disjoint, in order, and all that is. Where what is
//       between the ends of two hits has no t of few doubles, it is not looked into: they are two parts, and is_next_near
//       is set. (Of three; of one, where the differences of coordinates of a and b are no doubles.)
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/pose.h>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace sunder::solid {

struct LineHit {
  std::uint32_t triangle = 0;
  ExactFraction first, last;  // of t
};

// The triangles of its ends; nothing: the beginning of a ray, or an end of a segment, inside of the mesh.
struct LinePart {
  ExactFraction first, last;
  std::optional<std::uint32_t> enters, leaves;
  bool is_through = false;  // some of it is inside of the mesh, off its triangles
  bool is_next_near = false;
};

struct MeshAndLineApart {
  static constexpr Verdict verdict = Verdict::apart;
};
struct LineInMesh {
  static constexpr Verdict verdict = Verdict::meet;
  std::vector<LineHit> hits;  // by `first`, then by triangle
  std::vector<LinePart> parts;
};

// probes: boxes and triangles that were looked at; iterations: triangles that were asked about exactly
using MeshLine = Answer<std::variant<MeshAndLineApart, LineInMesh>>;

// Exact, the line in the world. Requires that the mesh can be placed so (mesh_mesh.h). Cost: the boxes of the mesh's tree
// that are not apart from the line, polyhedron_line for each triangle in them, and a point of each gap between hits.
MeshLine mesh_line(const Mesh& mesh, const Pose& pose, const LineLike& line);

// Each triangle.
MeshLine mesh_line_by_scan(const Mesh& mesh, const Pose& pose, const LineLike& line);

}  // namespace sunder::solid
