// Certificates of meshes that are exactly convex, or not (docs/claims.md, "mesh").
// None throws, but for want of memory, or what the writer's sink throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/solid/mesh/mesh_convexity.h>

#include <cstdint>
#include <optional>

namespace sunder::solid {

// The statement that the mesh bounds the hull of its vertices; or, with off_hull = face_off_hull(mesh, hull), that it
// does not, as this polygon is off the hull. Requires that this is so, that the hull is solid, and that the file has
// the table and the statement of write_hull(), of the vertices of this mesh and their hull.
// Cost: as of find_mesh_defect.
void write_mesh(ClaimsWriter& file, const MeshView& mesh, const ConvexPolyhedron& hull,
                std::optional<std::uint32_t> off_hull = std::nullopt);

}  // namespace sunder::solid
