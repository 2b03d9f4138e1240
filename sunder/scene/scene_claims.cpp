#include <sunder/certificate/pair_claims.h>
#include <sunder/scene/clearance_claims.h>
#include <sunder/scene/pair_reasons.h>
#include <sunder/scene/parts_as_meshes.h>
#include <sunder/scene/scene_claims.h>
#include <sunder/scene/scene_meshes.h>
#include <sunder/solid/round/round_claims.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::scene {

namespace {

// Of each part of each body, its number in the file.
using Numbers = std::vector<std::vector<std::uint32_t>>;

template <class Add>  // add(body, part)
Numbers numbers_of(std::span<const Body> bodies, const Add& add) {
  Numbers numbers;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    numbers.emplace_back();
    for (std::uint32_t p = 0; p < bodies[b].parts.size(); ++p) numbers.back().push_back(add(b, p));
  }
  return numbers;
}

// Is the statement of the pair none that says whether it counts? Then it is left out of what is said of all pairs.
bool is_open(const PartPair& pair, const Question& question) {
  return pair.undecided() || (question.touching_allowed && pair.meet() && pair.relation == Relation::none);
}

// Notes what is said of the statement about all pairs of a placement that follows.
class NotesOfPlacement {
 public:
  NotesOfPlacement(ClaimsWriter& file, const Question& question, const Numbers& numbers, const SaidOfScene& said,
                   std::size_t placement)
      : file_(file), joints_(said.joints_of(placement)), is_known_(!said.reasons.empty()) {
    std::set<std::array<std::uint32_t, 2>> allowed;
    for (std::size_t k = 0; k < question.allowed.size(); ++k) {
      const auto [a, b] = std::minmax(question.allowed[k][0], question.allowed[k][1]);
      if (a == b || !allowed.insert({a, b}).second) continue;
      allowed_.add(is_known_ ? said.reasons[k] : "", numbers[a].size() * numbers[b].size());
    }
  }

  void operator()(bool is_of_scene, const PairReasons& others) const {
    if (joints_) file_.note(*joints_);
    PairReasons reasons;
    if (is_of_scene) reasons = allowed_;
    const bool is_said = is_known_ || reasons.counts().empty();
    for (const auto& [reason, pairs] : others.counts()) reasons.add(reason, pairs);
    if (is_said && !reasons.counts().empty()) file_.note(SaidNote::allowed(reasons.counts()));
  }

 private:
  ClaimsWriter& file_;
  std::optional<SaidNote> joints_;
  bool is_known_;  // why pairs are allowed
  PairReasons allowed_;
};

// What was asked about, and what counts, by parts of bodies one after the other; told: as meshes; others: why pairs
// besides the allowed are left out.
AllPairs all_pairs(const Answer& answer, const Question& question, const Numbers& numbers, const ToldAsMeshes& told,
                   PairReasons& others) {
  AllPairs result;
  std::vector<std::uint32_t> first;  // of each body, where its parts begin
  for (std::uint32_t b = 0; b < numbers.size(); ++b) {
    first.push_back(static_cast<std::uint32_t>(result.members.size()));
    result.members.insert(result.members.end(), numbers[b].begin(), numbers[b].end());
    result.groups.insert(result.groups.end(), numbers[b].size(), b);
    for (std::uint32_t p = 0; p < numbers[b].size(); ++p) result.as_meshes.push_back(told.mesh(b, p));
  }
  result.touching_allowed = question.touching_allowed;
  std::set<std::array<std::uint32_t, 2>> allowed;
  for (const auto& pair : question.allowed) {
    const auto [a, b] = std::minmax(pair[0], pair[1]);
    if (a != b) allowed.insert({a, b});
  }
  for (const auto& [a, b] : allowed) {
    for (std::uint32_t i = 0; i < numbers[a].size(); ++i) {
      for (std::uint32_t j = 0; j < numbers[b].size(); ++j) result.besides.push_back({first[a] + i, first[b] + j});
    }
  }
  for (const PartPair& pair : answer.pairs) {
    const std::array<std::uint32_t, 2> members{first[pair.body_a] + pair.part_a, first[pair.body_b] + pair.part_b};
    // Two statements may be about one pair. If neither part stands for a mesh, the statement about bodies decides.
    const auto as_meshes = told.is_told(TwoParts::of(pair));
    const bool is_of_bodies = !pair.meshes && !result.as_meshes[members[0]] && !result.as_meshes[members[1]];
    const bool is_alone = as_meshes == false && !is_of_bodies;
    if (is_alone || is_open(pair, question)) {
      others.add(is_alone ? "meshes as they are, in a statement of their own" : "undecided", 1);
      result.besides.push_back(members);
    } else if (pair.counts) {
      result.contacts.push_back(members);
    }
  }
  std::sort(result.besides.begin(), result.besides.end());
  std::sort(result.contacts.begin(), result.contacts.end());
  return result;
}

// The statement about all pairs of a placement, with what is said of it.
void add_all_pairs(PairClaims& pairs, const Answer& answer, const Question& question, const Numbers& numbers,
                   const ToldAsMeshes& told, const NotesOfPlacement& note) {
  PairReasons others;
  const AllPairs all = all_pairs(answer, question, numbers, told, others);
  note(true, others);
  pairs.add_all_pairs(all);
}

// What the statement of the pair leaves open, if anything.
std::string open_text(std::span<const Body> bodies, const PartPair& pair) {
  return part_name(bodies[pair.body_a], pair.part_a) + " and " + part_name(bodies[pair.body_b], pair.part_b) +
         (pair.undecided() ? ", undecided whether they meet" : ", undecided whether they touch or overlap");
}

template <class Pair>  // CloserParts, CloserPair
std::string closer_open_text(std::span<const Body> bodies, const Pair& pair) {
  return part_name(bodies[pair.body_a], pair.part_a) + " and " + part_name(bodies[pair.body_b], pair.part_b) +
         ", undecided whether they are closer";
}

// Of each part its shape.
Numbers add_shapes(ClaimsWriter& file, PairClaims& pairs, std::span<const Body> bodies, const SaidOfScene& said) {
  return numbers_of(bodies, [&](std::uint32_t b, std::uint32_t p) {
    file.say(said.of(b, p));
    return solid::add_shape(pairs, part_name(bodies[b], p), bodies[b].parts[p].shape);
  });
}

std::uint32_t add_placed(PairClaims& pairs, const std::string& prefix, std::uint32_t shape, const Body& body,
                         std::uint32_t part) {
  const solid::PlacedRound at(body.parts[part].shape, body.parts[part].pose);
  return pairs.add_placed(prefix + part_name(body, part), shape, at.pose.affine());
}

// What of one placement is stated as meshes.
struct MeshesOfPlacement {
  SceneMeshes& meshes;
  std::size_t placement;
  std::span<const Body> placed;
  std::string prefix;

  // Their meshes, for the table.
  void add(std::span<const TwoParts> pairs) const {
    for (const TwoParts& pair : pairs) add(pair);
  }
  void add(const TwoParts& pair) const { meshes.add(placement, prefix, placed, pair); }

  StateOfMeshes states(const BodiesOfFile& bodies, const SaidOfScene& said) const {
    return [*this, bodies, &said](ToldAsMeshes& told, const TwoParts& pair, std::optional<double> least) {
      note_joints(bodies, said);
      if (least) {
        meshes.add_clearance(bodies, placement, placed, pair, *least);
        meshes.tell(told, placement, placed, pair, true);
      } else {
        meshes.add_distance(bodies, placement, placed, pair);
      }
    };
  }

  // Statements about these pairs of an answer (scene_meshes.h), and what they tell.
  ToldAsMeshes state(const BodiesOfFile& bodies, std::span<const PartPair> answers, const std::vector<TwoParts>& pairs,
                     const Question& question, const SaidOfScene& said) const {
    ToldAsMeshes told;
    const std::set<TwoParts> stated(pairs.begin(), pairs.end());
    for (const PartPair& pair : answers) {
      const TwoParts two = TwoParts::of(pair);
      if (!stated.contains(two)) continue;
      const auto as_meshes = pair.meshes ? pair.meshes : asked(two, question.contacts || question.touching_allowed);
      const bool is_told = as_meshes && meshes.add_pair(bodies, placement, placed, two, *as_meshes,
                                                        question.touching_allowed, [&] { note_joints(bodies, said); });
      meshes.tell(told, placement, placed, two, is_told);
    }
    return told;
  }

 private:
  // Two convex parts that meet, as meshes. Null where that cannot be asked.
  std::shared_ptr<const PairAsMeshes> asked(const TwoParts& pair, bool with_relation) const {
    const auto parts =
        PartsAsMeshes::of_any(placed[pair.body_a].parts[pair.part_a], placed[pair.body_b].parts[pair.part_b]);
    if (!parts) return nullptr;
    PairAsMeshes result = parts->ask();
    if (result.verdict() == Verdict::undecided) return nullptr;
    if (with_relation) result.relation = parts->relation(result);
    return std::make_shared<const PairAsMeshes>(std::move(result));
  }

  void note_joints(const BodiesOfFile& bodies, const SaidOfScene& said) const {
    bodies.claims.go_to_statements();
    if (const auto joints = said.joints_of(placement)) bodies.claims.file().note(*joints);
  }
};

// Requires a pair that is not undecided, and not decided as meshes.
void add_pair_claims(PairClaims& pairs, std::span<const Body> placed, const PartPair& pair, std::uint32_t of_a,
                     std::uint32_t of_b) {
  const Part &a = placed[pair.body_a].parts[pair.part_a], &b = placed[pair.body_b].parts[pair.part_b];
  const solid::PlacedRound in_a(a.shape, a.pose), in_b(b.shape, b.pose);
  solid::RoundContact contact;
  if (pair.relation != Relation::none) contact = round_round_contact(in_a, in_b, pair.answer.evidence);
  add_claims(pairs, of_a, in_a, of_b, in_b, pair.answer.evidence, contact);
}

BodiesOfFile bodies_of(PairClaims& claims, const Numbers& numbers) {
  return {claims, [&numbers](std::uint32_t body, std::uint32_t part) { return numbers[body][part]; }};
}

// What the statements of all placements leave open.
void add_open(Origin& origin, std::size_t count, const std::function<MeetingPlacement(std::size_t k)>& placement,
              const Question& question) {
  for (std::size_t k = 0; k < count; ++k) {
    const MeetingPlacement placed = placement(k);
    for (const PartPair& pair : placed.pairs) {
      if (is_open(pair, question)) origin.left_out.push_back(placed.title + ": " + open_text(placed.bodies, pair));
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    const MeetingPlacement placed = placement(k);
    for (const CloserPair& pair : placed.closer) {
      if (pair.is_undecided) origin.left_out.push_back(placed.title + ": " + closer_open_text(placed.bodies, pair));
    }
  }
}

}  // namespace

void write_certificate(std::span<const Placement> placements, const Question& question, Origin origin,
                       const TextSink& sink, const ClearanceQuestion& clearance, const SaidOfScene& said) {
  const std::span<const Body> bodies = placements.front().bodies;
  for (const auto& [a, b] : question.allowed) {
    origin.left_out.push_back(bodies[a].name + " and " + bodies[b].name + ", which may meet");
  }
  const auto prefix_of = [&](const Placement& placed) {
    return placements.size() > 1 ? std::string(placed.title) + ": " : "";
  };
  for (const Placement& placed : placements) {
    for (const PartPair& pair : placed.answer.pairs) {
      if (!is_open(pair, question)) continue;
      origin.left_out.push_back(prefix_of(placed) + open_text(bodies, pair));
    }
  }
  for (const Placement& placed : placements) {
    if (!placed.clearance) continue;
    for (const CloserParts& pair : placed.clearance->undecided) {
      origin.left_out.push_back(prefix_of(placed) + closer_open_text(bodies, pair));
    }
  }
  ClaimsWriter file(sink);
  file.add_origin(origin);
  SceneMeshes meshes(file, said);
  for (std::size_t k = 0; k < placements.size(); ++k) {
    const Placement& placed = placements[k];
    const MeshesOfPlacement here{meshes, k, placed.bodies, prefix_of(placed)};
    here.add(pairs_as_meshes(placed.bodies, placed.answer));
    if (placed.clearance) here.add(pairs_as_meshes(placed.bodies, clearance));
    if (placed.nearest) here.add(pairs_as_meshes(placed.bodies, question.allowed, *placed.nearest));
  }
  meshes.end_table();
  PairClaims pairs(file);
  const Numbers shapes = add_shapes(file, pairs, bodies, said);
  std::vector<Numbers> numbers;  // by placement
  for (const Placement& placed : placements) {
    const std::string prefix = prefix_of(placed);
    numbers.push_back(numbers_of(placed.bodies, [&](std::uint32_t b, std::uint32_t p) {
      return add_placed(pairs, prefix, shapes[b][p], placed.bodies[b], p);
    }));
  }
  meshes.add_around(bodies_of(pairs, shapes), bodies);
  for (std::size_t k = 0; k < placements.size(); ++k) {
    const std::span<const Body> placed = placements[k].bodies;
    const Answer& answer = placements[k].answer;
    for (const PartPair& pair : answer.pairs) {
      if (pair.undecided() || pair.meshes) continue;
      add_pair_claims(pairs, placed, pair, numbers[k][pair.body_a][pair.part_a], numbers[k][pair.body_b][pair.part_b]);
    }
    const MeshesOfPlacement here{meshes, k, placed, {}};
    const BodiesOfFile in_file = bodies_of(pairs, numbers[k]);
    const ToldAsMeshes told = here.state(in_file, answer.pairs, pairs_as_meshes(placed, answer), question, said);
    const NotesOfPlacement note(file, question, numbers[k], said, k);
    add_all_pairs(pairs, answer, question, numbers[k], told, note);
    const StateOfMeshes of_meshes = here.states(in_file, said);
    if (placements[k].clearance) {
      add_claims(pairs, placed, numbers[k], clearance, *placements[k].clearance, of_meshes, note);
    }
    if (placements[k].nearest) {
      add_claims(pairs, placed, numbers[k], question.allowed, *placements[k].nearest, of_meshes, note);
    }
  }
  pairs.end();
}

void write_meeting_certificate(std::span<const Body> bodies, std::size_t count,
                               const std::function<MeetingPlacement(std::size_t k)>& placement,
                               const Question& question, Origin origin, const TextSink& sink, const SaidOfScene& said) {
  origin.left_out.emplace_back("all pairs of bodies that no statement is about");
  add_open(origin, count, placement, question);
  ClaimsWriter file(sink);
  file.add_origin(origin);
  SceneMeshes meshes(file, said);
  for (std::size_t k = 0; k < count; ++k) {
    const MeetingPlacement placed = placement(k);
    const MeshesOfPlacement here{meshes, k, placed.bodies, placed.title + ": "};
    here.add(decided_as_meshes(placed.pairs));
    for (const CloserPair& pair : placed.closer) {
      if (pair.is_of_meshes) here.add(TwoParts::of(pair));
    }
  }
  meshes.end_table();
  PairClaims pairs(file);
  const Numbers shapes = add_shapes(file, pairs, bodies, said);
  // A statement may need a part as a body: this maps placement, body and part to the body's number in the file.
  std::map<std::tuple<std::size_t, std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  for (std::size_t k = 0; k < count; ++k) {
    const MeetingPlacement placed = placement(k);
    const auto add_part = [&](std::uint32_t body, std::uint32_t part, bool is_as_mesh) {
      if (is_as_mesh && mesh_of(placed.bodies[body].parts[part]) != nullptr) return;
      const auto [at, is_new] = numbers.try_emplace({k, body, part}, 0);
      if (is_new) at->second = add_placed(pairs, placed.title + ": ", shapes[body][part], placed.bodies[body], part);
    };
    const auto add = [&](const auto& pair, bool is_of_meshes) {
      add_part(pair.body_a, pair.part_a, is_of_meshes);
      add_part(pair.body_b, pair.part_b, is_of_meshes);
    };
    for (const PartPair& pair : placed.pairs) {
      if (pair.meet()) add(pair, pair.meshes != nullptr);
    }
    for (const CloserPair& pair : placed.closer) {
      if (!pair.is_undecided) add(pair, pair.is_of_meshes);
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    const MeetingPlacement placed = placement(k);
    const BodiesOfFile in_file{
        pairs, [&numbers, k](std::uint32_t body, std::uint32_t part) { return numbers.at({k, body, part}); }};
    const MeshesOfPlacement here{meshes, k, placed.bodies, {}};
    for (const PartPair& pair : placed.pairs) {
      if (!pair.meet() || pair.meshes) continue;
      if (const auto joints = said.joints_of(k)) file.note(*joints);
      add_pair_claims(pairs, placed.bodies, pair, in_file.number_of(pair.body_a, pair.part_a),
                      in_file.number_of(pair.body_b, pair.part_b));
    }
    here.state(in_file, placed.pairs, decided_as_meshes(placed.pairs), question, said);
    ToldAsMeshes untold;  // no statement is about all pairs
    for (const CloserPair& pair : placed.closer) {
      if (pair.is_undecided) continue;
      if (pair.is_of_meshes) {
        here.states(in_file, said)(untold, TwoParts::of(pair), pair.least);
        continue;
      }
      if (const auto joints = said.joints_of(k)) file.note(*joints);
      add_claims(pairs, in_file.number_of(pair.body_a, pair.part_a), placed.bodies[pair.body_a].parts[pair.part_a],
                 in_file.number_of(pair.body_b, pair.part_b), placed.bodies[pair.body_b].parts[pair.part_b],
                 pair.least);
    }
  }
  pairs.end();
}

void write_whole_certificate(std::span<const Body> bodies, std::size_t count,
                             const std::function<MeetingPlacement(std::size_t k)>& placement, const Question& question,
                             Origin origin, const TextSink& sink, const ClearanceQuestion* clearance,
                             const SaidOfScene& said) {
  for (const auto& [a, b] : question.allowed) {
    origin.left_out.push_back(bodies[a].name + " and " + bodies[b].name + ", which may meet");
  }
  add_open(origin, count, placement, question);
  Question of_all = question;
  of_all.every_pair = true;
  ClaimsWriter file(sink);
  file.add_origin(origin);
  SceneMeshes meshes(file, said);
  for (std::size_t k = 0; k < count; ++k) {
    const MeetingPlacement placed = placement(k);
    const MeshesOfPlacement here{meshes, k, placed.bodies, placed.title + ": "};
    here.add(pairs_as_meshes(placed.bodies, meeting_pairs(placed.bodies, of_all)));
    if (clearance != nullptr) here.add(pairs_as_meshes(placed.bodies, *clearance));
  }
  meshes.end_table();
  PairClaims pairs(file);
  const Numbers shapes = add_shapes(file, pairs, bodies, said);
  std::vector<Numbers> numbers;  // by placement
  for (std::size_t k = 0; k < count; ++k) {
    const MeetingPlacement placed = placement(k);
    numbers.push_back(numbers_of(bodies, [&](std::uint32_t b, std::uint32_t p) {
      return add_placed(pairs, placed.title + ": ", shapes[b][p], placed.bodies[b], p);
    }));
  }
  meshes.add_around(bodies_of(pairs, shapes), bodies);
  for (std::size_t k = 0; k < count; ++k) {
    const MeetingPlacement placed = placement(k);
    const Answer answer = meeting_pairs(placed.bodies, of_all);
    for (const PartPair& pair : answer.pairs) {
      if (pair.undecided() || pair.meshes) continue;
      add_pair_claims(pairs, placed.bodies, pair, numbers[k][pair.body_a][pair.part_a],
                      numbers[k][pair.body_b][pair.part_b]);
    }
    const MeshesOfPlacement here{meshes, k, placed.bodies, {}};
    const BodiesOfFile in_file = bodies_of(pairs, numbers[k]);
    const ToldAsMeshes told = here.state(in_file, answer.pairs, pairs_as_meshes(placed.bodies, answer), question, said);
    const NotesOfPlacement note(file, question, numbers[k], said, k);
    add_all_pairs(pairs, answer, question, numbers[k], told, note);
    if (clearance != nullptr) {
      add_claims(pairs, placed.bodies, numbers[k], *clearance, closer_pairs(placed.bodies, *clearance),
                 here.states(in_file, said), note);
    }
  }
  pairs.end();
}

}  // namespace sunder::scene
