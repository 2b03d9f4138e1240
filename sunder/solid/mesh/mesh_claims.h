// Certificates of exactly convex meshes (docs/claims.md, "mesh").
// None throws, but for want of memory, or what the writer's sink throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/solid/mesh/mesh_convexity.h>

namespace sunder::solid {

// The statement that the mesh bounds the hull of its vertices. Requires that it does, that the hull is solid, and that
// the file has the table and the statement of write_hull(), of the vertices of this mesh and their hull.
// Cost: as of find_mesh_defect.
void write_convex_mesh(ClaimsWriter& file, const MeshView& mesh, const ConvexPolyhedron& hull);

}  // namespace sunder::solid
