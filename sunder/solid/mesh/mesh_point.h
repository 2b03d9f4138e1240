// Is a point inside of a mesh, in its surface, or outside?
// Also called: point-in-polyhedron, point in solid; generalized winding number; ray casting, crossing number.
//
// The closed pieces together bound the inside (Mesh::is_by_winding). A point is inside if they wind around it, or,
// where only a parity tells, if a ray from it crosses them an odd number of times. Of open pieces nothing is asked here
// but whether the point is on them.
//
// A segment from the point to somewhere beyond the mesh is moved until it meets each triangle in an inner point of
// both, or not at all; almost every segment is so. The crossings, with their signs, sum up to the winding number.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/number/dyadic.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
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
  // How often the closed pieces wind around it, where all of them are oriented: 1 inside of one whose triangles are
  // counter-clockwise seen from outside, -1 if the pose mirrors it. Else the number of crossings modulo 2. Nothing
  // where it is on a triangle.
  std::optional<std::int64_t> winding;
  Cost cost;  // probes: boxes of the tree and triangles that were looked at; proposals: segments that were tried
};

// How often the segment from one point to another leaves what the closed pieces bound, less how often it enters: a sum
// of signs, whatever the pieces. Nothing where it has a point in common with an edge of one of their triangles, or one
// of its ends is on a triangle.
// Exact. cost.probes grows by the boxes of the tree and the triangles that are looked at.
std::optional<std::int64_t> crossings_along(const PlacedMesh& placed, const Posed3& from, const Posed3& to, Cost& cost);

// The same, of these triangles and those below these nodes of the tree alone.
std::optional<std::int64_t> crossings_among(const PlacedMesh& placed, const Posed3& from, const Posed3& to,
                                            std::span<const std::uint32_t> nodes,
                                            std::span<const std::uint32_t> triangles, Cost& cost);

// From a point that is on no triangle of a closed piece: the direction of a ray that meets no edge of a closed piece, and
// goes on beyond the mesh; and what it tells, as MeshPoint::winding. Exact. What mesh_point() requires, and costs.
struct RayAway {
  std::array<Dyadic, 3> along;
  std::int64_t winding = 0;
};
RayAway ray_away(const PlacedMesh& placed, const Posed3& point);

// Is it on a triangle? Exact.
bool is_on_triangle(const PlacedMesh& placed, const Posed3& point, Cost& cost);

// Exact. Both in the world. Requires that the entries of the pose are below 2^1000, or the coordinates of the mesh
// below 2^1020. Cost: what is near the point, and near a segment from it out of the mesh.
MeshPoint mesh_point(const Mesh& mesh, const Pose& pose, const Posed3& point);
MeshPoint mesh_point(const Mesh& mesh, const Pose& pose, const Point3& point);

}  // namespace sunder::solid
