// That a convex polyhedron holds all points of a mesh, as plain data: of each point a simplex that has it.
#pragma once

#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace sunder::solid {

// Simplices of vertices of the polyhedron, and for each point of the mesh which of them has it: a vertex, or a triangle
// of a flat polyhedron, or a tetrahedron, whose vertices are not on a line, or in a plane.
struct MeshHolders {
  std::vector<std::vector<std::uint32_t>> holders;
  std::vector<std::uint32_t> held;
};

// Exact. Tetrahedra have vertex 0, and are found by where the line from there through a point leaves the polyhedron.
// Nothing where the polyhedron has not all points, or is a segment, and a point is between its ends. Cost for each point
// that is no vertex: that of polyhedron_line(), and the logarithm of the facet's vertices; of a flat polyhedron they are
// all looked at.
std::optional<MeshHolders> mesh_holders(const Mesh& mesh, const ConvexPolyhedron& body);

// By each point and all simplices of the facets.
std::optional<MeshHolders> mesh_holders_by_scan(const Mesh& mesh, const ConvexPolyhedron& body);

}  // namespace sunder::solid
