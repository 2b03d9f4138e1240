// The walk down the trees of two meshes.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/function_ref.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/placed_mesh.h>

namespace sunder::solid {

// Calls of_pair with each two triangles that meet, until it returns true. Returns whether it did. Cost: as of mesh_mesh().
bool any_meeting_triangles(const PlacedMesh& a, const PlacedMesh& b, Cost& cost, StageTally& tally,
                           FunctionRef<bool(const MeetingTriangles&)> of_pair);

}  // namespace sunder::solid
