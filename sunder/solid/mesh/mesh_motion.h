// Do two meshes, as they are, meet at any time, while they move straight from where they are to where they will be? And
// when first?
// Also called: continuous collision detection of translations; linear sweep of meshes; time of impact.
//
// Time goes from 0 to 1, and no mesh turns; all is as of convex bodies (polyhedron_polyhedron_sweep.h). Meshes are as in
// mesh_mesh.h: so one that is inside of the other at time 0 meets it then.
//   M1. The answer is that of the exact images at all real times, the ends included. The first time is exact.
//   M2. Meshes that are apart at time 0 first meet, if at all, where two triangles do: what gets inside of a mesh comes
//       through its surface. So the first time is the least one of all pairs of triangles.
// What one might assume and does not hold: several pairs of triangles may meet first; which one is named is not said.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/solid/exact/sweep_contact.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/object/translation.h>

#include <cstdint>
#include <memory>
#include <variant>

namespace sunder::solid {

// The meshes are apart at time 0, and these triangles are the first to meet, at that time. Weights of the contact name
// points of the meshes; its direction parts these triangles at all times before. (It is zero where the time is 0: never
// here.)
struct TrianglesOnTheWay {
  static constexpr Verdict verdict = Verdict::meet;
  std::uint32_t of_a = 0, of_b = 0;
  std::shared_ptr<const SweepContact> contact;
};

// Apart all the time; meeting at time 0 as mesh_mesh() tells; or later.
// probes: pairs of boxes and of triangles that were compared; iterations: pairs of triangles that exact numbers decided
using MeshMotion = Answer<std::variant<MeshesApart, MeetingTriangles, PointWithin, TrianglesOnTheWay>>;

// nullptr where they never meet, or do so at time 0.
inline const SweepContact* contact_on_the_way(const MeshMotion& answer) {
  const auto* later = std::get_if<TrianglesOnTheWay>(&answer.evidence);
  return later != nullptr ? later->contact.get() : nullptr;
}

// How they meet at time 0. Requires that they do.
MeshEvidence evidence_at_start(const MeshMotion& answer);

// The first time. Requires that they meet.
ExactFraction first_time_of(const MeshMotion& answer);

// Exact. Requires that each can be placed so at both ends (mesh_mesh.h). Cost: that of mesh_mesh() at time 0; the pairs
// of boxes that may meet no later than the meshes do; a linear program in integers (sweep_simplex.h) for each pair of
// triangles that floating point does not tell to meet later, or never. Allocates a queue of pairs of boxes.
MeshMotion mesh_motion(const Mesh& a, const Translation& of_a, const Mesh& b, const Translation& of_b);

// The same by comparing each triangle of A with each one of B, in exact numbers.
MeshMotion mesh_motion_by_scan(const Mesh& a, const Translation& of_a, const Mesh& b, const Translation& of_b);

}  // namespace sunder::solid
