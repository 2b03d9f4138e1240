// The parts of a scene that certificate files state something of as meshes, and where they are in each placement: the
// table `meshes`, which stands before that of bodies, and the statements about two of them, or one and a body.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/scene.h>
#include <sunder/scene/scene_said.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <tuple>

namespace sunder::scene {

// Two parts of different bodies.
struct TwoParts {
  std::uint32_t body_a = 0, body_b = 0, part_a = 0, part_b = 0;

  template <class Pair>  // PartPair, PartDistance, CloserPair
  static TwoParts of(const Pair& pair) {
    return {pair.body_a, pair.body_b, pair.part_a, pair.part_b};
  }
};

// The bodies of a file, and the number in it of a part in one placement.
struct BodiesOfFile {
  PairClaims& claims;
  std::function<std::uint32_t(std::uint32_t body, std::uint32_t part)> number_of;
};

// Keeps references to what it is made of.
class SceneMeshes {
 public:
  SceneMeshes(ClaimsWriter& file, const SaidOfScene& said) : claims_(file), said_(said) {}

  // Adds the meshes of two parts where they are placed, unless they are there already. Requires parts that are asked about
  // as meshes (parts_as_meshes.h). Placements come in their order; the names of meshes begin with the prefix. end_table()
  // comes after all.
  void add(std::size_t placement, const std::string& prefix, std::span<const Body> placed, const TwoParts& pair);
  void end_table() { claims_.end_table(); }

  // Statements about two that were added: how they were decided; whether they are `least` apart, or more; how far they
  // are. They are made where they are written. Require that it is decided; of a part with a radius, that it is one of
  // the bodies of the file.
  void add_pair(const BodiesOfFile& bodies, std::size_t placement, std::span<const Body> placed, const PartPair& pair);
  void add_clearance(const BodiesOfFile& bodies, std::size_t placement, std::span<const Body> placed,
                     const TwoParts& pair, double least);
  void add_distance(const BodiesOfFile& bodies, std::size_t placement, std::span<const Body> placed,
                    const TwoParts& pair);

 private:
  void add(std::size_t placement, const std::string& prefix, const Body& body, std::uint32_t b, std::uint32_t p);
  solid::StatedMesh stated(std::size_t placement, std::span<const Body> placed, std::uint32_t body,
                           std::uint32_t part) const;
  struct StatedBeside;
  StatedBeside beside(const BodiesOfFile& bodies, std::size_t placement, std::span<const Body> placed,
                      const TwoParts& pair) const;

  solid::MeshClaims claims_;
  const SaidOfScene& said_;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> meshes_;                           // by body and part
  std::map<std::tuple<std::size_t, std::uint32_t, std::uint32_t>, std::uint32_t> placed_;  // by placement, too
};

}  // namespace sunder::scene
