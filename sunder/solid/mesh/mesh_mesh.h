// Do two meshes meet, as they are? Each is the solid that its closed pieces bound, and the surface of its open ones.
// Also called: mesh collision, mesh-mesh intersection; interference, clash detection.
//
// They meet iff two of their triangles do, or the surfaces are apart and a piece of one, which is connected, is inside
// of the other with all its points. Touching is meeting. What an open piece seems to enclose is not asked.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/pose.h>

#include <cstdint>
#include <variant>

namespace sunder::solid {

// No triangle of one meets one of the other, and no piece of one is inside of the other.
struct MeshesApart {
  static constexpr Verdict verdict = Verdict::apart;
};

// These two triangles have a common point.
struct MeetingTriangles {
  static constexpr Verdict verdict = Verdict::meet;
  std::uint32_t of_a = 0, of_b = 0;
};

// The surfaces are apart, and this point, a corner of a triangle of A (or of B), is inside of the other mesh.
struct PointWithin {
  static constexpr Verdict verdict = Verdict::meet;
  bool is_of_a = true;
  std::uint32_t point = 0;
};

using MeshEvidence = std::variant<MeshesApart, MeetingTriangles, PointWithin>;
// probes: pairs of boxes and of triangles that were compared; iterations: pairs of triangles that signs decided
using MeshAnswer = Answer<MeshEvidence>;

// Can it be asked about there? Its numbers are not beyond all that searches can bear: the entries of the pose are below
// 2^1000, or the coordinates of the mesh below 2^1020.
bool can_be_placed(const Mesh& mesh, const Pose& pose);
void require_can_be_placed(const Mesh& mesh, const Pose& pose);  // throws Error bad_pose

// Exact, under poses. Requires that each can be placed so. Cost: the pairs of nodes of both trees (mesh_tree.h) whose
// boxes are not apart; where no two triangles meet, for each piece that is not beyond the other mesh what is near a
// segment from it out of that. Allocates nothing, but where signs take long exact numbers.
MeshAnswer mesh_mesh(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b);

// Each triangle with each.
MeshAnswer mesh_mesh_by_scan(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b);

}  // namespace sunder::solid

namespace sunder {

// As solid::mesh_mesh. Throws Error bad_pose where one cannot be placed so.
solid::MeshAnswer intersect(const solid::Mesh& a, const solid::Pose& pose_a, const solid::Mesh& b,
                            const solid::Pose& pose_b);

}  // namespace sunder
