// What questions of sunder pair about meshes as they are share.
#pragma once

#include <sunder/ask/pair/pair_question.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/solid/mesh/mesh.h>

#include <cstddef>

namespace sunder::ask {

// The mesh of a bounded object. A flat polygon has two sides, so that its edges bound nothing.
solid::Mesh mesh_of_placed(const PlacedBody& placed);

// Throws Error for numbers that no product of double precision holds.
void require_range(const solid::Mesh& mesh, const solid::Pose& pose, const PairSide& side);

// As the answer tells of it.
PairObject object_of_mesh(const PlacedBody& placed, const solid::Mesh& mesh);

// How many pieces are surfaces, which bound nothing?
std::size_t open_pieces(const solid::Mesh& mesh);

// Answers a pair of meshes of which one moves, or both. Throws Error where one turns, or its numbers are out of range.
Report run_mesh_motion_pair(const PairCall& call, const PlacedBody& a, const PlacedBody& b, const PairFiles& files);

class MeshQuestion : public PairQuestion {
 public:
  using PairQuestion::PairQuestion;

 protected:
  // Tells that what open pieces seem to enclose was not asked. Requires that the two are apart, and that no single plane
  // parts them. open: the number of open pieces.
  void tell_what_is_not_enclosed(std::size_t open);
};

}  // namespace sunder::ask
