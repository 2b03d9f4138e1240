#include <sunder/scene/scene_meshes.h>

#include <sunder/solid/mesh/mesh_distance.h>

namespace sunder::scene {

void SceneMeshes::add(std::size_t placement, const std::string& prefix, std::span<const Body> placed,
                      const TwoParts& pair) {
  add(placement, prefix, placed[pair.body_a], pair.body_a, pair.part_a);
  add(placement, prefix, placed[pair.body_b], pair.body_b, pair.part_b);
}

void SceneMeshes::add(std::size_t placement, const std::string& prefix, const Body& body, std::uint32_t b,
                      std::uint32_t p) {
  const Part& part = body.parts[p];
  const auto [mesh, is_new] = meshes_.try_emplace({b, p}, 0);
  if (is_new) mesh->second = claims_.add_mesh(part_name(body, p), *mesh_of(part), said_.as_mesh(b, p));
  const auto [at, is_new_there] = placed_.try_emplace({placement, b, p}, 0);
  if (is_new_there) at->second = claims_.add_placed(prefix + part_name(body, p), mesh->second, part.pose);
}

std::array<solid::StatedMesh, 2> SceneMeshes::stated(std::size_t placement, std::span<const Body> placed,
                                                     const TwoParts& pair) const {
  const auto of = [&](std::uint32_t b, std::uint32_t p) {
    const Part& part = placed[b].parts[p];
    return solid::StatedMesh{placed_.at({placement, b, p}), *mesh_of(part), part.pose};
  };
  return {of(pair.body_a, pair.part_a), of(pair.body_b, pair.part_b)};
}

void SceneMeshes::add_pair(std::size_t placement, std::span<const Body> placed, const PartPair& pair) {
  const auto [a, b] = stated(placement, placed, TwoParts::of(pair));
  claims_.add_pair(a, b, pair.meshes->answer.evidence, &pair.meshes->relation);
}

void SceneMeshes::add_clearance(std::size_t placement, std::span<const Body> placed, const TwoParts& pair,
                                double least) {
  const auto [a, b] = stated(placement, placed, pair);
  claims_.add_clearance(a, b, mesh_distance(a.mesh, a.pose, b.mesh, b.pose), least);
}

void SceneMeshes::add_distance(std::size_t placement, std::span<const Body> placed, const TwoParts& pair) {
  const auto [a, b] = stated(placement, placed, pair);
  claims_.add_distance(a, b, mesh_distance(a.mesh, a.pose, b.mesh, b.pose));
}

}  // namespace sunder::scene
