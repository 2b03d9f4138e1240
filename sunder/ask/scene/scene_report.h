// What `sunder scene` tells: text and JSON.
#pragma once

#include <sunder/ask/scene/scene_clearance.h>
#include <sunder/ask/scene/scene_input.h>

#include <sunder/scene/scene.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

// One placement and its answer.
struct Placed {
  std::map<std::string, double> joints;
  std::string title;  // for people: the placement's name, or its number
  std::vector<scene::Body> bodies;
  scene::Answer answer;
  scene::Nearness near{};
  std::optional<scene::Answer> of_allowed{};  // about the pairs that are allowed to meet, where they were asked about
  double seconds = 0;                         // of the question itself, without reading files
};

struct SceneReport {
  const robot::Cell& cell;
  std::string method;
  scene::Question question{};
  std::optional<scene::ClearanceQuestion> clearance{};
  bool asks_for_nearest = false;
  std::vector<std::string> allowed_because{};  // as the user wrote it
  std::vector<AllowedPair> allowed{};          // those of the question, with their reasons
  bool checks_allowed = false;
  bool surfaces_consented = false;   // what open pieces of meshes seem to enclose need not be asked about
  std::vector<Placed> placements{};  // at least one, all with the same bodies
  bool colour = false;               // mark what meets by terminal colours

  std::string_view verdict() const;  // "some", "none"; "undecided": none that is known
  bool none_meet() const { return verdict() == "none"; }
  bool none_undecided() const;
  bool is_kept() const;                  // no pair is closer than its margin
  std::uint64_t surfaces_alone() const;  // pairs, as scene::Counts has them
};

// "hand and post/2"; is one of them a hull that replaces a mesh; which pair a list tells of. A pair has body_a, part_a,
// body_b and part_b.
template <class Pair>
std::string names_of(const Placed& placed, const Pair& pair) {
  return part_name(placed.bodies[pair.body_a], pair.part_a) + " and " +
         part_name(placed.bodies[pair.body_b], pair.part_b);
}
template <class Pair>
bool is_hull(const SceneReport& report, const Pair& pair) {
  return report.cell.is_hull(pair.body_a, pair.part_a) || report.cell.is_hull(pair.body_b, pair.part_b);
}
template <class Pair>
Json begun_json(const SceneReport& report, std::size_t placement, const Pair& pair) {
  const std::vector<scene::Body>& bodies = report.placements[placement].bodies;
  return {{"placement", placement},
          {"a", bodies[pair.body_a].name},
          {"b", bodies[pair.body_b].name},
          {"part_a", pair.part_a},
          {"part_b", pair.part_b}};
}

// Where contacts were asked for: "none", "touching", "overlapping", "equal", "the first a part of the second" and the
// like; "touching or overlapping" where it is not known; "undecided" of a pair that is.
std::string_view contact_name(const scene::PartPair& pair);
bool has_unknown_contact(const scene::PartPair& pair);

// Says that `pairs` pairs of meshes are apart as surfaces, where a mesh of each pair has an open piece.
std::string surfaces_alone_text(std::uint64_t pairs, bool is_consented);

Json pair_evidence_json(const scene::PartPair& pair, const scene::Part& a, const scene::Part& b);

// What of all this a proof does not say, in words.
std::vector<std::string> not_proved(const SceneReport& report);

// The lines of the text that a picture of the placement has below its answer: what is allowed to meet, and does, and
// what was left out.
std::vector<std::string> picture_notes(const SceneReport& report, const Placed& placed);

// All but the method, the notes and the files that are written.
Report report_of(const SceneReport& scene);

}  // namespace sunder::ask
