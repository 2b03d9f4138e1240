#include <sunder/scene/parts_as_meshes.h>

#include <sunder/base/contract.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_round.h>
#include <sunder/solid/mesh/mesh_round_claims.h>

#include <algorithm>
#include <variant>

namespace sunder::scene {

namespace {

using solid::PlacedRound;

bool can_be_placed(const Part& part, const solid::Mesh* mesh) {
  return mesh != nullptr ? solid::can_be_placed(*mesh, part.pose)
                         : solid::can_be_placed(PlacedRound(part.shape, part.pose));
}

}  // namespace

std::optional<PartsAsMeshes> PartsAsMeshes::of(const Part& a, const Part& b) {
  return a.mesh != nullptr || b.mesh != nullptr ? of_any(a, b) : std::nullopt;
}

std::optional<PartsAsMeshes> PartsAsMeshes::of_any(const Part& a, const Part& b) {
  const solid::Mesh *mesh_a = mesh_of(a), *mesh_b = mesh_of(b);
  if (mesh_a == nullptr && mesh_b == nullptr) return std::nullopt;
  if (!can_be_placed(a, mesh_a) || !can_be_placed(b, mesh_b)) return std::nullopt;
  return PartsAsMeshes(a, b, mesh_a, mesh_b);
}

PartsAsMeshes::Beside PartsAsMeshes::beside() const {
  SUNDER_REQUIRE(!are_two());
  const Part &of_mesh = mesh_a_ != nullptr ? *a_ : *b_, &round = mesh_a_ != nullptr ? *b_ : *a_;
  return {mesh_a_ != nullptr ? *mesh_a_ : *mesh_b_, of_mesh.pose, PlacedRound(round.shape, round.pose)};
}

PairAsMeshes PartsAsMeshes::ask() const {
  if (are_two()) return {mesh_mesh(*mesh_a_, a_->pose, *mesh_b_, b_->pose)};
  const auto [mesh, pose, round] = beside();
  return {mesh_round(mesh, pose, round)};
}

solid::MeshRelation PartsAsMeshes::relation(const PairAsMeshes& met) const {
  if (!are_two()) return {};
  return mesh_relation(*mesh_a_, a_->pose, *mesh_b_, b_->pose, std::get<solid::MeshAnswer>(met.answer));
}

Point3 PartsAsMeshes::rounded_common_point(const PairAsMeshes& met) const {
  if (const auto* of_two = std::get_if<solid::MeshAnswer>(&met.answer)) {
    return solid::rounded_point_of(*mesh_a_, a_->pose, *mesh_b_, b_->pose, of_two->evidence);
  }
  const auto [mesh, pose, round] = beside();
  return solid::rounded_point_of(mesh, pose, round, std::get<solid::MeshRoundAnswer>(met.answer).evidence);
}

Verdict PartsAsMeshes::clearance(double least) const {
  if (are_two()) {
    return are_meshes_closer(*mesh_a_, a_->pose, *mesh_b_, b_->pose, least) ? Verdict::meet : Verdict::apart;
  }
  const auto [mesh, pose, round] = beside();
  return mesh_round_clearance(mesh, pose, round, least).verdict();
}

std::optional<solid::RoundDistanceEvidence> PartsAsMeshes::distance() const {
  if (are_two()) {
    const solid::MeshDistance found = mesh_distance(*mesh_a_, a_->pose, *mesh_b_, b_->pose);
    if (const solid::NearTriangles* nearest = nearest_of(found)) return nearest->closest;
    return std::nullopt;
  }
  const auto [mesh, pose, round] = beside();
  const solid::MeshRoundDistance found = mesh_round_distance(mesh, pose, round, mesh_round(mesh, pose, round));
  if (found.distance.high == 0) return std::nullopt;
  const solid::RoundBody triangle = body_of_triangle(mesh, found.nearest);
  const PlacedRound placed(triangle, pose);
  solid::RoundDistanceEvidence evidence =
      (mesh_a_ != nullptr ? round_distance(placed, round) : round_distance(round, placed)).evidence;
  if (auto* curved = std::get_if<solid::CurvedApart>(&evidence)) {
    curved->distance.low = std::min(curved->distance.low, found.distance.low);
  }
  return evidence;
}

bool PartsAsMeshes::are_closed() const {
  return (mesh_a_ == nullptr || mesh_a_->is_closed()) && (mesh_b_ == nullptr || mesh_b_->is_closed());
}

}  // namespace sunder::scene
