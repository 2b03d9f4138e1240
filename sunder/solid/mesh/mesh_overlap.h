// Points that tell how the insides of two meshes that meet lie to each other, searched where they may be expected.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/mesh/mesh_mesh.h>

#include <cstdint>
#include <optional>

namespace sunder::solid {

// Does something of these kinds exist: a point that is inside of both meshes, of A and not of B, of B and not of A, and
// on no triangle of either?
struct InsideKinds {
  bool both = false, only_a = false, only_b = false;

  bool are_all() const { return both && only_a && only_b; }
};

struct PointsInside {
  InsideKinds found;
  std::optional<Point3> in_both;  // of the world, where one was found
};

// Kinds of which a point is found, exactly. Looks beside what the two triangles of the evidence have in common, to either
// side of both, at three distances, from an eighth of their size down to 2^-30 of it; or beside the corner that is inside;
// then, for what is inside of one alone, beside the middles of up to 16 triangles of it. Where a mesh has an open piece, a
// point inside of both is searched beside four pairs of triangles, and no other kind is asked for. What is not found may exist
// nevertheless. Requires that both meet, as the evidence says. Cost: at most 24 times that of mesh_point() for either mesh, and
// where one of the last two kinds is not found there, 144 times more.
PointsInside points_inside(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                           const MeshEvidence& evidence);

// Is something inside next to the middle of the triangle, on either side? As floating point finds the middle and the
// sides; false where it finds none.
bool has_inside_beside(const Mesh& mesh, const Pose& pose, std::uint32_t triangle);

}  // namespace sunder::solid
