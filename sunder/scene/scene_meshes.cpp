#include <sunder/scene/scene_meshes.h>

#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/mesh/mesh_round_claims.h>

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

void SceneMeshes::add_pair(const BodiesOfFile& bodies, std::size_t placement, std::span<const Body> placed,
                           const PartPair& pair) {
  const TwoParts two = TwoParts::of(pair);
  if (const auto* answer = std::get_if<solid::MeshAnswer>(&pair.meshes->answer)) {
    return claims_.add_pair(stated(placement, placed, pair.body_a, pair.part_a),
                            stated(placement, placed, pair.body_b, pair.part_b), answer->evidence,
                            &pair.meshes->relation);
  }
  const auto [mesh, index, body] = beside(bodies, placement, placed, two);
  add_claims(bodies.claims, mesh, index, body, std::get<solid::MeshRoundAnswer>(pair.meshes->answer).evidence);
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
