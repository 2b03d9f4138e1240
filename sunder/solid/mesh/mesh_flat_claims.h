// Writes whether a mesh, as it is, and a line, a ray or a plane meet into a certificate file: docs/claims.md, "Meshes", the
// question `mesh_body`.
// Each throws only std::bad_alloc, and what the file's sink throws.
#pragma once

#include <sunder/certificate/common_point.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/line/flat_body.h>
#include <sunder/solid/mesh/mesh_line.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_plane.h>
#include <sunder/solid/mesh/parts_beside.h>

#include <cstdint>

namespace sunder::solid {

// Require that they are apart.
PartsBeside parts_beside(const Mesh& mesh, const Pose& pose, const LineLike& line);
PartsBeside parts_beside(const Mesh& mesh, const Pose& pose, const Plane& plane);

// A point of the triangle that the plane has.
ExactPoint3 common_point(const Mesh& mesh, const Pose& pose, const Plane& plane, std::uint32_t triangle);

// State it of a mesh and a body of the file's tables, of which that of meshes stands first. Of a line and a ray the body is
// as body_of(LineLike) makes it; of a plane it is given.
void add_claims(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const LineLike& line,
                const MeshLine& answer);
void add_claims(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const Plane& plane,
                const FlatBody& in_file, const MeshPlane& answer);

}  // namespace sunder::solid
