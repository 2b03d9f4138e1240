// Writes the answer about two meshes as they are into a certificate file: docs/claims.md, "Meshes". The table `meshes`
// has the points and triangles of each mesh in its own order (mesh.h, M5).
// Each throws only std::bad_alloc, and what the file's sink throws.
#pragma once

#include <sunder/certificate/asked_pair.h>
#include <sunder/certificate/claims.h>
#include <sunder/certificate/common_point.h>
#include <sunder/certificate/said.h>
#include <sunder/solid/mesh/mesh_mesh.h>

#include <string>

namespace sunder::solid {

// A mesh, where it is, and what it is called, and said to be made of.
struct NamedMesh {
  std::string name;
  const Mesh& mesh;
  const Pose& pose;
  Said said{};
};

// A point that the triangles have in common, with weights of points of the meshes. Requires that they do.
CommonPoint common_point(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                         const MeetingTriangles& evidence);

// The table, and the one statement; the file's origin stands before, and its end is not written. Cost: that of
// mesh_cover() where they are apart; else linear in both meshes.
void add_claims(ClaimsWriter& file, const NamedMesh& a, const NamedMesh& b, const MeshAnswer& answer);

// The certificate file of the answer, whole (asked_pair.h).
void prove(const TextSink& sink, const AskedPair<Mesh, Pose>& asked, const MeshAnswer& answer);

}  // namespace sunder::solid
