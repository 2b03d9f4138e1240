// The evidence of an answer in JSON, with rounded numbers. The exact ones are in certificate files.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/certificate/direction.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_round.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/round/round_round.h>

namespace sunder::ask {

// apart: {"direction_about", "gap_about", "extreme_a", "extreme_b"}; meet: {"point_about", "vertices_a", "vertices_b"}.
Json evidence_json(const PairCertificate& certificate, const PlacedVertices& a, const PlacedVertices& b);

// The same for two polyhedra. For other bodies, apart: {"direction_about", "gap_about"}; meet: {"point"}; undecided:
// {"direction_about"}.
Json evidence_json(const solid::RoundEvidence& evidence, const solid::PlacedRound& a, const solid::PlacedRound& b);

// The same of two meshes as they are. apart: {"planes", "rays"}, of their cover; meet: {"point", "face_a", "face_b"} or
// {"corner", "within"}.
Json evidence_json(const solid::MeshEvidence& evidence, const solid::Mesh& a, const solid::Pose& pose_a,
                   const solid::Mesh& b, const solid::Pose& pose_b);

// The same of a mesh as it is, which is A or B, and a body with a radius. apart: {"planes", "rays"}, of the parts of the
// mesh; meet: {"point", "face"}, of the mesh, or {"point", "within"}; undecided: {"direction_about"}.
Json evidence_json(const solid::MeshRoundEvidence& evidence, const solid::Mesh& mesh, const solid::Pose& pose,
                   const solid::PlacedRound& round, bool is_mesh_a);

// Adds what the body is made of: {"points", "radius"}, {"points", "semi_axes"}.
void add_numbers(const solid::RoundWords& words, Json& json);

}  // namespace sunder::ask
