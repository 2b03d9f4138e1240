// The parts of a scene that certificate files state something of as meshes, and where they are in each placement: the
// table `meshes`, which stands before that of bodies, and the statements about two of them, or one and a body.
//
// A statement about all pairs is about bodies, of which some stand for meshes. So of a pair with such a member it is
// stated that the bodies are apart, which hold the meshes; or something of the mesh itself. Two convex parts that meet
// are stated as meshes, too, where one of them stands for a mesh in another pair.
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
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::scene {

// Two parts of different bodies.
struct TwoParts {
  std::uint32_t body_a = 0, body_b = 0, part_a = 0, part_b = 0;

  template <class Pair>  // PartPair, PartDistance, CloserPair
  static TwoParts of(const Pair& pair) {
    return {pair.body_a, pair.body_b, pair.part_a, pair.part_b};
  }
  friend auto operator<=>(const TwoParts&, const TwoParts&) = default;
};

// The pairs that are stated as meshes, and those of `others` of which a part is a mesh in one of them, and so on.
std::vector<TwoParts> spread(std::vector<TwoParts> stated, std::span<const TwoParts> others,
                             std::span<const Body> placed);

// The pairs of an answer that were decided as meshes; and all that are stated so.
std::vector<TwoParts> decided_as_meshes(std::span<const PartPair> pairs);
std::vector<TwoParts> pairs_as_meshes(std::span<const Body> placed, const Answer& answer);

// What one statement about all pairs has from those about meshes: which of these pairs they tell, and the meshes of the
// file that parts stand for.
class ToldAsMeshes {
 public:
  using Part = std::pair<std::uint32_t, std::uint32_t>;  // body and part

  void add(const TwoParts& pair, bool is_told, std::optional<std::uint32_t> mesh_a,
           std::optional<std::uint32_t> mesh_b);

  // Nothing where the pair is not stated as meshes.
  std::optional<bool> is_told(const TwoParts& pair) const;
  std::optional<std::uint32_t> mesh(std::uint32_t body, std::uint32_t part) const;

 private:
  std::map<TwoParts, bool> told_;
  std::map<Part, std::uint32_t> meshes_;
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

  // States of each mesh, once, that the shape of its part holds its points; comes before other statements.
  // number_of(body, part): of the shape, in the file.
  void add_around(const BodiesOfFile& shapes, std::span<const Body> bodies);

  // What a statement about all pairs has from one about this pair. is_told: it tells whether that counts.
  void tell(ToldAsMeshes& told, std::size_t placement, std::span<const Body> placed, const TwoParts& pair,
            bool is_told) const;

  // Statements about two that were added: how they were decided; whether they are `least` apart, or more; how far they
  // are. They are made where they are written. Require that it is decided; of a part with a radius, that it is one of
  // the bodies of the file. add_pair: do they tell whether the pair counts? note() comes before each.
  bool add_pair(const BodiesOfFile& bodies, std::size_t placement, std::span<const Body> placed, const TwoParts& pair,
                const PairAsMeshes& answer, bool touching_allowed, const std::function<void()>& note);
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
  std::optional<std::uint32_t> held_mesh(std::size_t placement, std::uint32_t body, std::uint32_t part) const;

  solid::MeshClaims claims_;
  const SaidOfScene& said_;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> meshes_;                           // by body and part
  std::set<std::array<std::uint32_t, 2>> held_;                                            // by their shapes
  std::map<std::tuple<std::size_t, std::uint32_t, std::uint32_t>, std::uint32_t> placed_;  // by placement, too
};

}  // namespace sunder::scene
