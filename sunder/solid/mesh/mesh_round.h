// Do a mesh, as it is, and a convex body with a radius or without meet? How far apart are they, are they closer than
// that? Balls, capsules, cylinders, cones, ellipsoids.
// Also called: mesh-primitive collision and distance; sphere against triangle mesh, capsule against mesh.
//
// The mesh is the solid that its closed pieces bound, and the surface of its open ones (mesh.h). Touching is meeting.
//   R1. apart and meet are exactly right for the doubles given. The body meets a triangle, or is inside of the solid with
//       all its points, as it hangs together.
//   R2. Decided always: hulls of any radii (balls, capsules, rounded hulls). Others as round_round (round_round.h, R3,
//       R4) decides them of each triangle, a polyhedron of radius 0; and round_clearance (round_clearance.h, C2).
//   R3. The distance is enclosed, as by round_distance (round_distance.h, D1 to D4) of each triangle.
// What one might assume and does not hold: a body may meet a mesh's hull, and be apart from the mesh.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/number/interval.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/round/round_body.h>

#include <cstdint>
#include <variant>

namespace sunder::solid {

// The body meets no triangle, and is not inside of the mesh.
struct MeshAndRoundApart {
  static constexpr Verdict verdict = Verdict::apart;
};

// The body has a point of this triangle.
struct RoundOnTriangle {
  static constexpr Verdict verdict = Verdict::meet;
  std::uint32_t triangle = 0;
};

// It meets no triangle, and is inside of the mesh with all its points.
struct RoundWithinMesh {
  static constexpr Verdict verdict = Verdict::meet;
};

// It is not known whether it meets this triangle; it meets none of the others, and its first point is not inside.
struct RoundNearTriangle {
  static constexpr Verdict verdict = Verdict::undecided;
  std::uint32_t triangle = 0;
};

using MeshRoundEvidence = std::variant<MeshAndRoundApart, RoundOnTriangle, RoundWithinMesh, RoundNearTriangle>;
// probes: pairs of boxes and of triangles that were compared; iterations: triangles that were asked about exactly
using MeshRoundAnswer = Answer<MeshRoundEvidence>;

// The triangle as a body without a radius, in the frame of its mesh.
RoundBody body_of_triangle(const Mesh& mesh, std::uint32_t triangle);

// Are the body's numbers not beyond all that searches of meshes can bear, as of can_be_placed() in mesh_mesh.h?
bool can_be_placed(const PlacedRound& body);

// Exact, under poses. Requires that each can be placed so. Cost: the boxes of the mesh's tree that are not apart from
// the core of the body, as far as it reaches around that, times those of the core; and round_round for each triangle
// of which floating point does not tell. Where none meets the body, besides, what is near a segment from it out of the
// mesh.
MeshRoundAnswer mesh_round(const Mesh& mesh, const Pose& pose, const PlacedRound& body);

// Each triangle by round_round.
MeshRoundAnswer mesh_round_by_scan(const Mesh& mesh, const Pose& pose, const PlacedRound& body);

// Are they that far apart, or further? `apart`: yes, exactly so far counts; `meet`: no, this triangle is nearer, or the
// body is inside. Requires a finite `least` > 0. Cost: as of mesh_round(), of a body that is wider by `least`.
MeshRoundAnswer mesh_round_clearance(const Mesh& mesh, const Pose& pose, const PlacedRound& body, double least);
MeshRoundAnswer mesh_round_clearance_by_scan(const Mesh& mesh, const Pose& pose, const PlacedRound& body, double least);

// How far apart they are: low <= the distance <= high, {0, 0} only where they meet. `nearest`: the nearest triangle (where
// the body is curved, one that is no further than `high`); where they meet and none is known to, any.
struct MeshRoundDistance {
  Interval distance{0, 0};
  std::uint32_t nearest = 0;
  Cost cost;
};
// Requires the answer of mesh_round() about these. Cost: round_distance for each triangle that is no further from the
// core than the nearest one and as far as the body reaches around that; of hulls few.
MeshRoundDistance mesh_round_distance(const Mesh& mesh, const Pose& pose, const PlacedRound& body,
                                      const MeshRoundAnswer& met);
MeshRoundDistance mesh_round_distance_by_scan(const Mesh& mesh, const Pose& pose, const PlacedRound& body,
                                              const MeshRoundAnswer& met);

}  // namespace sunder::solid

namespace sunder {

// As solid::mesh_round. Throws Error bad_pose where one cannot be placed so, or as PlacedRound (round_body.h).
solid::MeshRoundAnswer intersect(const solid::Mesh& mesh, const solid::Pose& pose, const solid::RoundBody& body,
                                 const solid::Pose& pose_body);

}  // namespace sunder
