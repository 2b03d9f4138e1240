#include <sunder/certificate/pair_claims.h>
#include <sunder/scene/sweep_claims.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_round_claims.h>
#include <sunder/solid/round/round_claims.h>

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace sunder::scene {

namespace {

std::string names_of(std::span<const Body> bodies, const SweptPair& pair) {
  return part_name(bodies[pair.body_a], pair.part_a) + " and " + part_name(bodies[pair.body_b], pair.part_b);
}

// The parts of bodies in a file, where they are in each placement: each once.
class PlacedParts {
 public:
  PlacedParts(ClaimsWriter& file, PairClaims& pairs, std::span<const Body> bodies, const SaidOfScene& said)
      : pairs_(pairs) {
    for (const Body& body : bodies) {
      shapes_.emplace_back();
      for (std::uint32_t p = 0; p < body.parts.size(); ++p) {
        file.say(said.of(shapes_.size() - 1, p));
        shapes_.back().push_back(solid::add_shape(pairs, part_name(body, p), body.parts[p].shape));
      }
    }
  }

  // Adds it, where it is not there yet. Of a placement after the last one all that was before is forgotten, but for the
  // one before it.
  std::uint32_t number_of(std::size_t placement, const Body& placed, std::uint32_t body, std::uint32_t part) {
    while (newest_ < placement) {
      ++newest_;
      known_[0] = std::exchange(known_[1], {});
    }
    const auto [at, is_new] = known_[placement == newest_ ? 1 : 0].try_emplace({body, part}, 0);
    if (is_new) {
      const solid::PlacedRound in_place(placed.parts[part].shape, placed.parts[part].pose);
      at->second = pairs_.add_placed(std::to_string(placement) + ": " + part_name(placed, part), shapes_[body][part],
                                     in_place.pose.affine());
    }
    return at->second;
  }

 private:
  PairClaims& pairs_;
  std::vector<std::vector<std::uint32_t>> shapes_;
  std::array<std::map<std::array<std::uint32_t, 2>, std::uint32_t>, 2> known_;  // of the last but one, and the last
  std::size_t newest_ = 0;
};

// Parts as meshes in a file, where they are in each placement: each once. The table stands before that of bodies.
class PlacedMeshes {
 public:
  PlacedMeshes(ClaimsWriter& file, const SaidOfScene& said) : claims_(file), said_(said) {}

  // A part with a radius is a body of the file, and no mesh.
  void add(std::size_t placement, const Body& placed, std::uint32_t body, std::uint32_t part) {
    const solid::Mesh* const mesh = mesh_of(placed.parts[part]);
    if (mesh == nullptr) return;
    const auto [base, is_new] = meshes_.try_emplace({body, part}, 0);
    if (is_new) base->second = claims_.add_mesh(part_name(placed, part), *mesh, said_.as_mesh(body, part));
    const auto [at, is_new_there] = placed_.try_emplace({placement, body, part}, 0);
    if (is_new_there) {
      at->second = claims_.add_placed(std::to_string(placement) + ": " + part_name(placed, part), base->second,
                                      placed.parts[part].pose);
    }
  }
  void end_table() { claims_.end_table(); }

  solid::StatedMesh stated(std::size_t placement, const Body& placed, std::uint32_t body, std::uint32_t part) const {
    const Part& of = placed.parts[part];
    return {placed_.at({placement, body, part}), *mesh_of(of), of.pose};
  }
  solid::MeshClaims& claims() { return claims_; }

 private:
  solid::MeshClaims claims_;
  const SaidOfScene& said_;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> meshes_;                           // by body and part
  std::map<std::tuple<std::size_t, std::uint32_t, std::uint32_t>, std::uint32_t> placed_;  // by placement, too
};

// What is stated of two meshes, from one placement to the next.
class StatedAsMeshes {
 public:
  StatedAsMeshes(PlacedMeshes& meshes, std::size_t step, const SweptStep& at, const SweptPair& pair)
      : meshes_(meshes), step_(step), at_(at), pair_(pair) {}

  void add_to_table() const {
    for (const bool is_end : {false, true}) {
      meshes_.add(placement(is_end), body(is_end, true), pair_.body_a, pair_.part_a);
      meshes_.add(placement(is_end), body(is_end, false), pair_.body_b, pair_.part_b);
    }
  }

  void state_motion() const {
    const solid::Translation of_a = way(true), of_b = way(false);
    solid::MeshMotion answer;
    if (const auto* meet = std::get_if<MeshesMeetOnTheWay>(&pair_.evidence)) answer = *meet->motion;
    meshes_.claims().add_motion({stated(false, true), stated(true, true).index, of_a},
                                {stated(false, false), stated(true, false).index, of_b}, answer);
  }

  // number_of: of a part with a radius, among the bodies.
  template <class NumberOf>
  void state_at_end(PairClaims& pairs, const MeetAtAnEnd& end, const NumberOf& number_of) const {
    const bool is_end = end.time != 0;
    const PairAsMeshes& found = *end.pair->meshes;
    if (const auto* of_two = std::get_if<solid::MeshAnswer>(&found.answer)) {
      return meshes_.claims().add_pair(stated(is_end, true), stated(is_end, false), of_two->evidence, &found.relation);
    }
    const bool is_mesh_a = mesh_of(part(is_end, true)) != nullptr;
    const Part& round = part(is_end, !is_mesh_a);
    add_claims(pairs, stated(is_end, is_mesh_a), number_of(!is_mesh_a), solid::PlacedRound(round.shape, round.pose),
               std::get<solid::MeshRoundAnswer>(found.answer).evidence);
  }

 private:
  std::size_t placement(bool is_end) const { return is_end ? step_ + 1 : step_; }
  const Body& body(bool is_end, bool is_a) const {
    return (is_end ? at_.end : at_.begin)[is_a ? pair_.body_a : pair_.body_b];
  }
  const Part& part(bool is_end, bool is_a) const {
    return body(is_end, is_a).parts[is_a ? pair_.part_a : pair_.part_b];
  }
  solid::Translation way(bool is_a) const { return {part(false, is_a).pose, part(true, is_a).pose}; }
  solid::StatedMesh stated(bool is_end, bool is_a) const {
    return meshes_.stated(placement(is_end), body(is_end, is_a), is_a ? pair_.body_a : pair_.body_b,
                          is_a ? pair_.part_a : pair_.part_b);
  }

  PlacedMeshes& meshes_;
  std::size_t step_;
  const SweptStep& at_;
  const SweptPair& pair_;
};

void add_at_an_end(PairClaims& pairs, const PartPair& pair, const Part& a, const Part& b, std::uint32_t of_a,
                   std::uint32_t of_b) {
  const solid::PlacedRound in_a(a.shape, a.pose), in_b(b.shape, b.pose);
  add_claims(pairs, of_a, in_a, of_b, in_b, pair.answer.evidence);
}

}  // namespace

void write_motion_certificate(std::span<const Body> bodies, std::size_t count,
                              const std::function<SweptStep(std::size_t k)>& step, const Question& question,
                              Origin origin, const TextSink& sink, const SaidOfScene& said) {
  if (question.every_pair) {
    for (const auto& [a, b] : question.allowed) {
      origin.left_out.push_back(bodies[a].name + " and " + bodies[b].name + ", which may meet");
    }
    origin.left_out.push_back("what turns between two placements, between them");
  } else {
    origin.left_out.push_back("all pairs of bodies that no statement is about");
  }
  for (std::size_t k = 0; k < count; ++k) {
    const SweptStep at = step(k);
    for (const SweptPair& pair : at.pairs) {
      if (!pair.undecided()) continue;
      origin.left_out.push_back(std::to_string(k) + " to " + std::to_string(k + 1) + ": " + names_of(bodies, pair) +
                                ", undecided whether they meet");
    }
  }
  ClaimsWriter file(sink);
  file.add_origin(origin);
  PlacedMeshes meshes(file, said);
  for (std::size_t k = 0; k < count; ++k) {
    const SweptStep at = step(k);
    for (const SweptPair& pair : at.pairs) {
      if (pair.is_of_meshes()) StatedAsMeshes(meshes, k, at, pair).add_to_table();
    }
  }
  meshes.end_table();
  PairClaims pairs(file);
  PlacedParts parts(file, pairs, bodies, said);
  std::vector<solid::ClaimedMotion> numbers;  // of each pair that is stated; of one at an end both are there
  for (std::size_t k = 0; k < count; ++k) {
    const SweptStep at = step(k);
    for (const SweptPair& pair : at.pairs) {
      if (pair.undecided()) continue;
      const auto number = [&](bool is_end, std::uint32_t body, std::uint32_t part) -> std::uint32_t {
        if (pair.is_of_meshes() && mesh_of(at.begin[body].parts[part]) != nullptr) return 0;  // it is no body
        return parts.number_of(is_end ? k + 1 : k, (is_end ? at.end : at.begin)[body], body, part);
      };
      const auto* end = std::get_if<MeetAtAnEnd>(&pair.evidence);
      const bool begins = end == nullptr || end->time == 0, ends = end == nullptr || !begins;
      solid::ClaimedMotion& of = numbers.emplace_back();
      of.a = number(!begins, pair.body_a, pair.part_a);
      of.b = number(!begins, pair.body_b, pair.part_b);
      of.to_a = number(ends, pair.body_a, pair.part_a);
      of.to_b = number(ends, pair.body_b, pair.part_b);
    }
  }
  auto next = numbers.begin();
  for (std::size_t k = 0; k < count; ++k) {
    const SweptStep at = step(k);
    for (const SweptPair& pair : at.pairs) {
      if (pair.undecided()) continue;
      const solid::ClaimedMotion& of = *next++;
      pairs.go_to_statements();
      for (const std::size_t placement : {k, k + 1}) {
        if (const auto joints = said.joints_of(placement)) file.note(*joints);
      }
      const auto* const end = std::get_if<MeetAtAnEnd>(&pair.evidence);
      if (pair.is_of_meshes()) {
        const StatedAsMeshes stated(meshes, k, at, pair);
        end == nullptr ? stated.state_motion()
                       : stated.state_at_end(pairs, *end, [&](bool is_a) { return is_a ? of.a : of.b; });
      } else if (const auto* meet = std::get_if<MeetOnTheWay>(&pair.evidence)) {
        add_claims(pairs, of, *meet->first);
      } else if (const auto* apart = std::get_if<ApartOnTheWay>(&pair.evidence)) {
        pairs.add_motion_apart(of.a, of.b, of.to_a, of.to_b, *apart->direction);
      } else {
        const std::span<const Body> there = end->time == 0 ? at.begin : at.end;
        add_at_an_end(pairs, *end->pair, there[pair.body_a].parts[pair.part_a], there[pair.body_b].parts[pair.part_b],
                      of.a, of.b);
      }
    }
  }
  pairs.end();
}

}  // namespace sunder::scene
