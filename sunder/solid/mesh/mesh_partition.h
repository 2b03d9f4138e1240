// A tree of planes that tells where what two meshes bound has common points, and where it has not.
// Also called: binary space partition (BSP tree); set membership classification; regularized Boolean operations.
//
// A cell is the open part of space on one side of each plane of a path down the tree. Where no triangle of a mesh goes
// through it, all of a cell is inside of that mesh or nothing is. Cells are cut, by planes of triangles and across the
// axes, until that tells enough.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/number/dyadic.h>
#include <sunder/solid/mesh/fine_point.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_overlap.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace sunder::solid {

struct MeshPartition {
  struct Plane {
    std::array<Dyadic, 4> numbers;  // the points x with n x = d: n, d
  };
  // Whether the point is inside of A tells that of all of the cell, or of B: no triangle of that mesh has a point in the
  // cell, unless it has no area. (A proof has a ray from the point, as ray_away() of mesh_point.h finds it.)
  struct Cell {
    FinePoint point;  // on no triangle of the mesh that it tells of
    bool tells_a = false, tells_b = false;
  };

  // A walk from the root, which is all of space: 1, the cell is cut by the next plane, and what follows is about the part
  // above it (n x > d), then about the part below; 0, the next one of `cells`.
  std::vector<std::int64_t> cuts;
  std::vector<Plane> planes;
  std::vector<Cell> cells;
};

struct Partitioned {
  // False: the budget was spent, or a cell was too thin for a point with coordinates of four doubles.
  bool is_decided = false;
  InsideKinds found;
  std::optional<FinePoint> in_both;  // a point that is inside of both, where that was not known
  // If one of the three kinds was not found, the points tell of each cell that it has no point of that kind. If all were
  // found, the walk stopped early, and the tree is not whole.
  MeshPartition partition;
  Cost
      cost;  // probes: corners, and boxes of the meshes' trees, that were compared with a plane; iterations: polygons clipped
};

// Which kinds there are, besides those that are known. Exact. `meeting`: planes of these two triangles are tried first, where
// they are given. Requires that both meshes are closed, and what mesh_mesh() requires. Cost: at most 100 n (2 + log2 n)
// probes, n the triangles of both, which is the budget; of what lies beyond a plane with all its box, only the box is looked
// at.
Partitioned mesh_partition(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b, InsideKinds known,
                           const std::optional<MeetingTriangles>& meeting = {});

}  // namespace sunder::solid
