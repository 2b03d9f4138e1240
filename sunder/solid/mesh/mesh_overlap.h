// Do the insides of two meshes that meet have a common point?
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/mesh/mesh_mesh.h>

#include <optional>

namespace sunder::solid {

// A point of the world that is inside of both: it is searched near what pairs of triangles have in common, 64 pairs at
// most, at distances from a quarter of the size of the smaller mesh down to 2^-42 of it, and each is checked exactly.
// Nothing where none is found: the meshes touch, or overlap so little, or have no inside there. Requires that they meet,
// as the evidence says. Cost: for each pair at most 48 times that of mesh_point().
std::optional<Point3> point_inside_both(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                                        const MeshEvidence& evidence);

}  // namespace sunder::solid
