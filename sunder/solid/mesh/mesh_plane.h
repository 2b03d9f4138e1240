// Do a mesh, as it is, and a plane meet? On which side of it are the pieces?
// Also called: plane-mesh intersection; half-space test of a mesh.
//
// A plane meets the solid that closed pieces bound iff it meets a triangle: it goes on for ever, and the solid does not.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/plane.h>
#include <sunder/solid/object/pose.h>

#include <cstdint>
#include <variant>
#include <vector>

namespace sunder::solid {

// No triangle has a point of the plane. all: above it (positive), below it (negative), or some pieces on either side
// (zero). `nearest`: the point that is nearest to it, about.
struct MeshBesidePlane {
  static constexpr Verdict verdict = Verdict::apart;
  Sign all = Sign::zero;
  std::uint32_t nearest = 0;
};

// This triangle has a point of it. below, above: has the mesh points strictly below the plane, strictly above it? Where
// one of the two is not so, they only touch.
struct MeshAcrossPlane {
  static constexpr Verdict verdict = Verdict::meet;
  std::uint32_t triangle = 0;
  bool below = false, above = false;
};

using MeshPlane = Answer<std::variant<MeshBesidePlane, MeshAcrossPlane>>;

// Exact, the plane in the world. Cost: a sign for each point.
MeshPlane mesh_plane(const Mesh& mesh, const Pose& pose, const Plane& plane);

// On which side is each point?
std::vector<Sign> sides_of_plane(const Mesh& mesh, const Pose& pose, const Plane& plane,
                                 std::uint32_t* exact = nullptr);

}  // namespace sunder::solid
