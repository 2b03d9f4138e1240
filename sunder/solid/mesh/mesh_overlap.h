// Points that tell how the insides of two meshes that meet lie to each other, searched where they may be expected.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/mesh/mesh_mesh.h>

#include <cstdint>
#include <optional>

namespace sunder::solid {

// A point of the world that is inside of both: it is searched near what pairs of triangles have in common, four of
// them, at distances from a quarter of the size of the smaller mesh down to 2^-42 of it, and each is checked exactly.
// Nothing where none is found: the meshes touch, or overlap so little, or have no inside there. Requires that they meet,
// as the evidence says. Cost: for each pair at most 24 times that of mesh_point() for either mesh.
std::optional<Point3> point_inside_both(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                                        const MeshEvidence& evidence);

// Is a point known that is inside of the first mesh, and not of the other, nor on a triangle of it? It is searched beside
// the middles of 16 triangles of the first. False: none was found. Cost: as above.
bool knows_point_of_first_only(const Mesh& first, const Pose& pose_first, const Mesh& other, const Pose& pose_other);

// Is something inside next to the middle of the triangle, on either side? As floating point finds the middle and the
// sides; false where it finds none.
bool has_inside_beside(const Mesh& mesh, const Pose& pose, std::uint32_t triangle);

}  // namespace sunder::solid
