// How far apart are two meshes, as they are? The nearest triangles, the exact distance; and: are they closer than that?
// Also called: separation distance, minimum distance; clearance, proximity query with a cutoff; closest points.
//
//   D1. Meshes that meet (mesh_mesh.h) are at distance 0. Else the distance is that of the two triangles named, of all
//       the least, exactly; it is enclosed, compared and made as of convex bodies (polyhedron_polyhedron_distance.h).
//   D2. compare_distance is exact for every finite radius; what is exactly `least` apart is not closer than that.
// What one might assume and does not hold: several pairs of triangles may be as near; which one is named is not said.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/number/interval.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <cstdint>
#include <variant>

namespace sunder::solid {

// Two meshes are apart. These two triangles have the nearest points; the features are the corners that hold these points,
// named by their numbers in the meshes.
struct NearTriangles {
  static constexpr Verdict verdict = Verdict::apart;
  std::uint32_t of_a = 0, of_b = 0;
  ClosestFeatures closest;
};

// probes: pairs of boxes and of triangles that were compared; iterations: steps of exact searches
using MeshDistance = Answer<std::variant<MeetingTriangles, PointWithin, NearTriangles>>;

// nullptr where they meet; and 0.
inline const NearTriangles* nearest_of(const MeshDistance& answer) {
  return std::get_if<NearTriangles>(&answer.evidence);
}
inline Interval distance_of(const MeshDistance& answer) {
  const NearTriangles* nearest = nearest_of(answer);
  return nearest != nullptr ? nearest->closest.distance() : Interval{0, 0};
}

// Exact, under poses. Requires that each can be placed so (mesh_mesh.h). Cost: that of mesh_mesh(), and twice the pairs
// of boxes that are no further apart than the meshes; a search in exact numbers for each pair of triangles that
// floating point does not tell from the nearest one.
MeshDistance mesh_distance(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b);

// The same by comparing each triangle of A with each one of B, in exact numbers: the oracle.
MeshDistance mesh_distance_by_scan(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b);

// positive: further apart than the radius; zero: exactly so far; negative: closer. Requires a finite radius >= 0.
Sign compare_distance(const MeshDistance& distance, double radius);

// compare_distance(mesh_distance(..), least) is negative; often sooner known. Requires a finite `least` > 0. Cost: that
// of mesh_mesh(), and the pairs of boxes that are closer than that, until two triangles are; `cost` becomes that.
bool are_meshes_closer(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b, double least,
                       Cost* cost = nullptr);

}  // namespace sunder::solid

namespace sunder {

// As solid::mesh_distance. Throws Error bad_pose where one cannot be placed so.
solid::MeshDistance distance(const solid::Mesh& a, const solid::Pose& pose_a, const solid::Mesh& b,
                             const solid::Pose& pose_b);

}  // namespace sunder
