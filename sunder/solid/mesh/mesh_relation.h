// How do two solids that meshes bound lie to each other: do they touch or overlap, is one a part of the other?
// Also called: clash detection, hard and soft; contact classification; mesh containment; RCC-8 relations in space.
//
// | solids                                                                 | relation      |
// |------------------------------------------------------------------------|---------------|
// | no common point                                                        | none          |
// | common points; no point is inside of both                              | touching      |
// | a point inside of both; neither is a part of the other                 | overlapping   |
// | A in the interior of B: the surfaces are apart                         | a_inside_b    |
// | A a part of B: what is inside of A is inside of B or on its triangles  | a_part_of_b   |
// | each is a part of the other                                            | equal         |
// | they meet, and one has an open piece, a sheet, or no inside            | meeting       |
// and the same with A and B exchanged. A point is inside as mesh_point.h says. A sheet is two triangles back to back with
// nothing inside beside them; it is seen where both have the same corners.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/certificate/pair.h>
#include <sunder/solid/mesh/fine_point.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_partition.h>

#include <optional>

namespace sunder::solid {

struct MeshRelation {
  Relation relation = Relation::none;
  // False: no more than this was found before a budget was spent (mesh_partition.h). Then `overlapping` means that a
  // point is inside of both, and `none` that it is not known whether there is one.
  bool is_known = true;
  std::optional<FinePoint> inside;         // of both; of overlapping ones
  std::optional<MeshPartition> partition;  // of those that touch, or of which one is a part of the other, or are equal
};

// Exact. The answer must be that of mesh_mesh() about the same meshes and poses. Cost: looks at some points; and where
// these do not tell, mesh_partition().
MeshRelation mesh_relation(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                           const MeshAnswer& answer);

}  // namespace sunder::solid
