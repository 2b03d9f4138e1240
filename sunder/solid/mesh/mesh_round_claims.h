// Writes whether a mesh, as it is, and a body with a radius meet into a certificate file: docs/claims.md, "Meshes", the
// question `mesh_body`.
// Each throws only std::bad_alloc, and what the file's sink throws.
#pragma once

#include <sunder/certificate/asked_pair.h>
#include <sunder/certificate/common_point.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_round.h>
#include <sunder/solid/mesh/parts_beside.h>

#include <cstdint>

namespace sunder::solid {

// For claims about a mesh and what is beside it: weights of vertices of the triangle's hull become those of points of the
// mesh; the claim of that rule.
void name_points_of_mesh(const Mesh& mesh, std::uint32_t triangle, const ConvexPolyhedron& of, Combination& made);
void add_parts(ClaimsWriter& file, const char* rule, const PartsBeside& parts);

// Requires that they are apart, as mesh_round() says, and `least` apart, as mesh_round_clearance() does, where that is
// not 0: then each direction shows so much. Exact. Cost: round_round, or round_clearance, for the parts down the mesh's
// tree that boxes, or hulls, do not part from the body, each with a look at its corners.
PartsBeside parts_beside(const Mesh& mesh, const Pose& pose, const PlacedRound& body, double least = 0);

// A point of the triangle that the body has, with how each makes it: of_a with weights of points of the mesh.
CommonPoint common_point(const Mesh& mesh, const Pose& pose, const PlacedRound& body, const RoundOnTriangle& evidence);

// A point that both have, rounded. Requires that they meet.
Point3 rounded_point_of(const Mesh& mesh, const Pose& pose, const PlacedRound& body, const MeshRoundEvidence& evidence);

// States it of a mesh and a body of the file's tables, of which that of meshes stands first. Requires that it is decided.
void add_claims(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const PlacedRound& body,
                const MeshRoundEvidence& evidence);

// The same of the answer of mesh_round_clearance().
void add_clearance(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const PlacedRound& body,
                   const MeshRoundEvidence& evidence, double least);

}  // namespace sunder::solid
