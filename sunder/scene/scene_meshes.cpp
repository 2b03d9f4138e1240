#include <sunder/scene/scene_meshes.h>

#include <sunder/scene/parts_as_meshes.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/mesh/mesh_holders.h>
#include <sunder/solid/mesh/mesh_overlap.h>
#include <sunder/solid/mesh/mesh_round_claims.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace sunder::scene {

namespace {

bool are_two(std::span<const Body> placed, const TwoParts& pair) {
  return mesh_of(placed[pair.body_a].parts[pair.part_a]) != nullptr &&
         mesh_of(placed[pair.body_b].parts[pair.part_b]) != nullptr;
}

}  // namespace

std::vector<TwoParts> spread(std::vector<TwoParts> stated, std::span<const TwoParts> others,
                             std::span<const Body> placed) {
  std::set<ToldAsMeshes::Part> meshes;
  const auto note = [&](const TwoParts& pair) {
    for (const auto& [b, p] : {std::pair(pair.body_a, pair.part_a), std::pair(pair.body_b, pair.part_b)}) {
      if (mesh_of(placed[b].parts[p]) != nullptr) meshes.insert({b, p});
    }
  };
  for (const TwoParts& pair : stated) note(pair);
  std::vector<TwoParts> left(others.begin(), others.end());
  for (std::size_t before = 0; before != stated.size();) {
    before = stated.size();
    std::erase_if(left, [&](const TwoParts& pair) {
      const bool is_of_one = meshes.contains({pair.body_a, pair.part_a}) || meshes.contains({pair.body_b, pair.part_b});
      if (is_of_one) {
        stated.push_back(pair);
        note(pair);
      }
      return is_of_one;
    });
  }
  return stated;
}

std::vector<TwoParts> decided_as_meshes(std::span<const PartPair> pairs) {
  std::vector<TwoParts> result;
  for (const PartPair& pair : pairs) {
    if (pair.meshes && !pair.undecided()) result.push_back(TwoParts::of(pair));
  }
  return result;
}

std::vector<TwoParts> pairs_as_meshes(std::span<const Body> placed, const Answer& answer) {
  std::vector<TwoParts> others;
  for (const PartPair& pair : answer.pairs) {
    const Part &a = placed[pair.body_a].parts[pair.part_a], &b = placed[pair.body_b].parts[pair.part_b];
    if (pair.meet() && a.mesh == nullptr && b.mesh == nullptr) others.push_back(TwoParts::of(pair));
  }
  return spread(decided_as_meshes(answer.pairs), others, placed);
}

void ToldAsMeshes::add(const TwoParts& pair, bool is_told, std::optional<std::uint32_t> mesh_a,
                       std::optional<std::uint32_t> mesh_b) {
  told_[pair] = is_told;
  if (!is_told) return;
  if (mesh_a) meshes_[{pair.body_a, pair.part_a}] = *mesh_a;
  if (mesh_b) meshes_[{pair.body_b, pair.part_b}] = *mesh_b;
}

std::optional<bool> ToldAsMeshes::is_told(const TwoParts& pair) const {
  const auto found = told_.find(pair);
  return found != told_.end() ? std::optional(found->second) : std::nullopt;
}

std::optional<std::uint32_t> ToldAsMeshes::mesh(std::uint32_t body, std::uint32_t part) const {
  const auto found = meshes_.find({body, part});
  return found != meshes_.end() ? std::optional(found->second) : std::nullopt;
}

void SceneMeshes::add_around(const BodiesOfFile& shapes, std::span<const Body> bodies) {
  for (const auto& [of, mesh] : meshes_) {
    const Part& part = bodies[of[0]].parts[of[1]];
    const auto holders = mesh_holders(*mesh_of(part), part.shape.core());
    if (!holders) continue;
    shapes.claims.go_to_statements();
    claims_.add_around(mesh, shapes.number_of(of[0], of[1]), *holders);
    held_.insert(of);
  }
}

std::optional<std::uint32_t> SceneMeshes::held_mesh(std::size_t placement, std::uint32_t body,
                                                    std::uint32_t part) const {
  const auto found = placed_.find({placement, body, part});
  return found != placed_.end() && held_.contains({body, part}) ? std::optional(found->second) : std::nullopt;
}

void SceneMeshes::tell(ToldAsMeshes& told, std::size_t placement, std::span<const Body> placed, const TwoParts& pair,
                       bool is_told) const {
  const auto mesh_a = held_mesh(placement, pair.body_a, pair.part_a),
             mesh_b = held_mesh(placement, pair.body_b, pair.part_b);
  const auto is_fit = [&](std::uint32_t body, std::uint32_t part, const std::optional<std::uint32_t>& mesh) {
    return mesh || mesh_of(placed[body].parts[part]) == nullptr;
  };
  told.add(pair, is_told && is_fit(pair.body_a, pair.part_a, mesh_a) && is_fit(pair.body_b, pair.part_b, mesh_b),
           mesh_a, mesh_b);
}

void SceneMeshes::add(std::size_t placement, const std::string& prefix, std::span<const Body> placed,
                      const TwoParts& pair) {
  add(placement, prefix, placed[pair.body_a], pair.body_a, pair.part_a);
  add(placement, prefix, placed[pair.body_b], pair.body_b, pair.part_b);
}

void SceneMeshes::add(std::size_t placement, const std::string& prefix, const Body& body, std::uint32_t b,
                      std::uint32_t p) {
  const Part& part = body.parts[p];
  const solid::Mesh* const of_part = mesh_of(part);
  if (of_part == nullptr) return;  // it has a radius, and is a body of the file
  const auto [mesh, is_new] = meshes_.try_emplace({b, p}, 0);
  if (is_new) mesh->second = claims_.add_mesh(part_name(body, p), *of_part, said_.as_mesh(b, p));
  const auto [at, is_new_there] = placed_.try_emplace({placement, b, p}, 0);
  if (is_new_there) at->second = claims_.add_placed(prefix + part_name(body, p), mesh->second, part.pose);
}

solid::StatedMesh SceneMeshes::stated(std::size_t placement, std::span<const Body> placed, std::uint32_t body,
                                      std::uint32_t part) const {
  const Part& of = placed[body].parts[part];
  return {placed_.at({placement, body, part}), *mesh_of(of), of.pose};
}

// A mesh, and a body of the file.
struct SceneMeshes::StatedBeside {
  solid::StatedMesh mesh;
  std::uint32_t index_of_body;
  solid::PlacedRound body;
};

SceneMeshes::StatedBeside SceneMeshes::beside(const BodiesOfFile& bodies, std::size_t placement,
                                              std::span<const Body> placed, const TwoParts& pair) const {
  const bool is_a = mesh_of(placed[pair.body_a].parts[pair.part_a]) != nullptr;
  const std::uint32_t body = is_a ? pair.body_b : pair.body_a, part = is_a ? pair.part_b : pair.part_a;
  const Part& round = placed[body].parts[part];
  return {
      is_a ? stated(placement, placed, pair.body_a, pair.part_a) : stated(placement, placed, pair.body_b, pair.part_b),
      bodies.number_of(body, part), solid::PlacedRound(round.shape, round.pose)};
}

bool SceneMeshes::add_pair(const BodiesOfFile& bodies, std::size_t placement, std::span<const Body> placed,
                           const TwoParts& pair, const PairAsMeshes& answer, bool touching_allowed,
                           const std::function<void()>& note) {
  note();
  const bool is_apart = answer.verdict() == Verdict::apart;
  const auto* const of_two = std::get_if<solid::MeshAnswer>(&answer.answer);
  if (of_two == nullptr) {
    const auto [mesh, index, body] = beside(bodies, placement, placed, pair);
    add_claims(bodies.claims, mesh, index, body, std::get<solid::MeshRoundAnswer>(answer.answer).evidence);
    return is_apart || !touching_allowed;  // whether they only touch is not told
  }
  const solid::StatedMesh a = stated(placement, placed, pair.body_a, pair.part_a),
                          b = stated(placement, placed, pair.body_b, pair.part_b);
  claims_.add_pair(a, b, of_two->evidence, &answer.relation);
  const Relation relation = answer.relation.relation;
  if (is_apart || relation == Relation::touching || relation == Relation::overlapping) return true;
  if (touching_allowed) {
    const auto inside = points_inside(a.mesh, a.pose, b.mesh, b.pose, of_two->evidence).in_both;
    if (!inside) return false;
    note();
    claims_.add_overlapping(a, b, solid::FinePoint{{*inside}});
  } else if (relation == Relation::a_part_of_b || relation == Relation::b_part_of_a || relation == Relation::equal) {
    note();  // these speak of insides, not of a common point
    claims_.add_pair(a, b, of_two->evidence);
  }
  return true;
}

void SceneMeshes::add_clearance(const BodiesOfFile& bodies, std::size_t placement, std::span<const Body> placed,
                                const TwoParts& pair, double least) {
  if (are_two(placed, pair)) {
    const solid::StatedMesh a = stated(placement, placed, pair.body_a, pair.part_a),
                            b = stated(placement, placed, pair.body_b, pair.part_b);
    return claims_.add_clearance(a, b, mesh_distance(a.mesh, a.pose, b.mesh, b.pose), least);
  }
  const auto [mesh, index, body] = beside(bodies, placement, placed, pair);
  solid::add_clearance(bodies.claims, mesh, index, body,
                       mesh_round_clearance(mesh.mesh, mesh.pose, body, least).evidence, least);
}

void SceneMeshes::add_distance(const BodiesOfFile& bodies, std::size_t placement, std::span<const Body> placed,
                               const TwoParts& pair) {
  if (are_two(placed, pair)) {
    const solid::StatedMesh a = stated(placement, placed, pair.body_a, pair.part_a),
                            b = stated(placement, placed, pair.body_b, pair.part_b);
    return claims_.add_distance(a, b, mesh_distance(a.mesh, a.pose, b.mesh, b.pose));
  }
  // As `nearest` states of curved bodies: that they are nearer than the next double above.
  const auto [mesh, index, body] = beside(bodies, placement, placed, pair);
  const solid::MeshRoundDistance found =
      mesh_round_distance(mesh.mesh, mesh.pose, body, mesh_round(mesh.mesh, mesh.pose, body));
  const double above = std::nextafter(found.distance.high, std::numeric_limits<double>::infinity());
  if (found.distance.high == 0 || !std::isfinite(above)) return;
  solid::add_clearance(bodies.claims, mesh, index, body, solid::RoundOnTriangle{found.nearest}, above);
}

}  // namespace sunder::scene
