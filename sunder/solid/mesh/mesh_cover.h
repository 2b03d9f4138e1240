// Why two meshes are apart, as plain data: planes between their parts, and rays that show that neither is in the other.
// Also called: bounding volume test tree (BVTT) front; separating front.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/solid/exact/sweep_contact.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/object/translation.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace sunder::solid {

// A walk over pairs of parts, which are triangles that follow each other: first all of A and all of B. Each number of
// `cuts` is about the next pair. k > 0: the part of A is cut before triangle k, and what follows is about the pair with
// what is before, then about the other one. -k: the same of B. 0: along the next one of `directions` the part of A ends
// before that of B begins. So every triangle of A is parted from every one of B.
//
// A ray goes from the first corner of a triangle along a direction, away from the other mesh: it meets none of the
// edges of that one's closed pieces, and crosses these as often inwards as outwards (where only a parity tells, an even
// number of times). There is one for each piece that could be inside of the other mesh: not for those that have a
// triangle in a part that is parted from all of the other mesh, and none where that has no closed piece.
struct MeshCover {
  struct Ray {
    std::uint32_t triangle = 0;
    std::array<Dyadic, 3> along;
  };

  std::vector<std::int64_t> cuts;
  std::vector<std::array<Dyadic, 3>> directions;
  std::vector<Ray> rays_a, rays_b;
};

// How far apart directions show parts to be. squared: of a distance; along the direction, one part begins that far behind
// the other, or further. 0: strictly behind it. way: a direction that may do for many parts; of the nearest points, say.
struct CoverWidth {
  ExactFraction squared{};
  std::optional<Vector3<Dyadic>> way{};
};

// Requires that the meshes are apart (mesh_mesh.h), and that far apart, and what mesh_mesh() requires. Exact: directions
// are checked, and where floating point finds none, exact numbers do. Cost: the pairs of parts of both trees that no
// planes part by so much, each times the points of the parts.
MeshCover mesh_cover(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                     const CoverWidth& width = {});

// Why no two triangles of a mesh cross. A walk over pairs of parts, as above, which begins with the pair of all triangles
// and themselves. k > 0 cuts a part that is paired with itself before triangle k: what follows is about the pair of what
// is before with itself, then about both, then about what is behind with itself. Pairs of single triangles that have a
// corner in common, by its number, and of one with itself, are passed over: a checker looks at these by itself.
struct MeshSelfCover {
  std::vector<std::int64_t> cuts;
  std::vector<std::array<Dyadic, 3>> directions;
};

// Nothing where a triangle has no area. Requires a mesh without crossings and T-junctions (mesh_crossings.h). Exact, as
// mesh_cover(). Cost: some twenty pairs for each triangle.
std::optional<MeshSelfCover> mesh_self_cover(const Mesh& mesh);

// The same of meshes that move: each direction parts the two parts at time 0 and at time 1, and so at all times between, as
// how far apart they are along it is linear in time. Where a contact is given: at time 0, and at the time of the contact,
// where they may touch; so they are apart along it before. Rays are of time 0. Requires that the meshes are apart all the
// time, or before the contact, which is the first one and not at time 0.
MeshCover mesh_cover_on_the_way(const Mesh& a, const Translation& of_a, const Mesh& b, const Translation& of_b,
                                const SweepContact* first = nullptr);

}  // namespace sunder::solid
