// Is a point inside of a mesh, in its surface, or outside?
// Also called: point-in-polyhedron, point in solid; generalized winding number; ray casting, crossing number.
//
// What is inside is told by the closed pieces together (Mesh::is_by_winding): the points around which they wind, or
// whose ray crosses them an odd number of times. Of open pieces nothing is asked here but whether the point is on them.
//
// A segment from the point to somewhere beyond the mesh is moved until it meets each triangle in an inner point of
// both, or not at all. The crossings, with their signs, sum up to the winding number.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace sunder::solid {

enum class MeshPlace : std::uint8_t {
  outside,
  on,      // it is on a triangle, closed or open
  inside,  // on none, and within what the closed pieces bound
};
std::string_view name_of(MeshPlace place);  // "outside", "on", "inside"

struct MeshPoint {
  MeshPlace place = MeshPlace::outside;
  // How often the closed pieces wind around it, where all of them are oriented; else the crossings modulo 2. Not where
  // it is on a triangle.
  std::optional<std::int64_t> winding;
  Cost cost;  // probes: boxes of the tree and triangles that were looked at
};

// The segment from one point to another crosses the closed pieces so often: once up and once down (predicate/line/
// space_triangles.h) cancel. Nothing where it touches a triangle of them elsewhere than in an inner point of both.
// Exact. cost.probes grows by the boxes of the tree and the triangles that are looked at.
std::optional<std::int64_t> crossings_along(const PlacedMesh& placed, const Posed3& from, const Posed3& to, Cost& cost);

// Exact. Both in the world. Cost: what is near the point, and near a segment from it out of the mesh.
MeshPoint mesh_point(const Mesh& mesh, const Pose& pose, const Posed3& point);
MeshPoint mesh_point(const Mesh& mesh, const Pose& pose, const Point3& point);

}  // namespace sunder::solid
