// Two parts as they are, of which one stands for a mesh: two meshes, or a mesh and a part with a radius.
#pragma once

#include <sunder/scene/scene.h>
#include <sunder/solid/round/round_distance.h>

#include <optional>

namespace sunder::scene {

class PartsAsMeshes {
 public:
  // Nothing where both are convex, or one cannot be placed so (mesh_mesh.h). Keeps references to both.
  static std::optional<PartsAsMeshes> of(const Part& a, const Part& b);

  // Also where both are convex, of which one stands for its surface. Nothing where both have a radius.
  static std::optional<PartsAsMeshes> of_any(const Part& a, const Part& b);

  PairAsMeshes ask() const;
  // How two meshes lie to each other, as that answer says whether they meet. Of others nothing is found.
  solid::MeshRelation relation(const PairAsMeshes& met) const;
  Point3 rounded_common_point(const PairAsMeshes& met) const;  // requires that they meet

  // `apart`: they are that far apart, or further; `meet`: they are not. Requires a finite `least` > 0.
  Verdict clearance(double least) const;
  // How far apart they are, from A to B. Nothing where they meet.
  std::optional<solid::RoundDistanceEvidence> distance() const;

  // Is no piece of either open?
  bool are_closed() const;

  // Null if part a has a radius.
  const solid::Mesh* mesh_a() const { return mesh_a_; }
  bool are_two() const { return mesh_a_ != nullptr && mesh_b_ != nullptr; }

  // The mesh and the other part. Requires that exactly one part is a mesh.
  struct Beside {
    const solid::Mesh& mesh;
    const solid::Pose& pose;
    solid::PlacedRound round;
  };
  Beside beside() const;

 private:
  PartsAsMeshes(const Part& a, const Part& b, const solid::Mesh* mesh_a, const solid::Mesh* mesh_b)
      : a_(&a), b_(&b), mesh_a_(mesh_a), mesh_b_(mesh_b) {}

  const Part *a_, *b_;
  const solid::Mesh *mesh_a_, *mesh_b_;
};

}  // namespace sunder::scene
