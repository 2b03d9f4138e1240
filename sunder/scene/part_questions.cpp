#include <sunder/scene/part_questions.h>
#include <sunder/scene/parts_as_meshes.h>

#include <memory>
#include <optional>
#include <tuple>
#include <utility>

namespace sunder::scene {

namespace {

using solid::PlacedRound;

Relation relation_of(const PartPair& pair, const Part& a, const Part& b) {
  const PlacedRound in_a(a.shape, a.pose), in_b(b.shape, b.pose);
  return round_round_relation(in_a, in_b, pair.answer.evidence);
}

}  // namespace

solid::WorldBox box_of(const Part& part) { return world_box(part.shape, part.pose); }

Box3 rough_box_of(const Part& part) { return rough_world_box(part.shape, part.pose); }

solid::RoundAnswer answer_of(const Part& a, const Part& b, const Question& question) {
  return round_round_by(question.method, a.shape, a.pose, b.shape, b.pose);
}

solid::RoundAnswer answer_of(const Part& a, const Part& b, const Question& question, PairWarmStart& last) {
  if (question.method != solid::polyhedron_polyhedron) return answer_of(a, b, question);
  return round_round_warm(a.shape, a.pose, b.shape, b.pose, last);
}

void look_closer(PartPair& pair, const Part& a, const Part& b) {
  if (pair.answer.verdict() == Verdict::apart) return;
  if (const auto parts = PartsAsMeshes::of(a, b)) pair.meshes = std::make_shared<const PairAsMeshes>(parts->ask());
}

void count_answer(PartPair& pair, const Part& a, const Part& b, const Question& question, Counts& counts) {
  ++counts.by_method;
  const auto as_meshes = pair.meshes ? PartsAsMeshes::of(a, b) : std::nullopt;
  if (as_meshes && pair.verdict() == Verdict::apart && !as_meshes->are_closed()) ++counts.surfaces_alone;
  if (pair.undecided()) ++counts.undecided;
  if (!pair.meet()) return;
  ++counts.meeting;
  pair.counts = true;
  if (!question.contacts && !question.touching_allowed) return;
  if (as_meshes) {
    PairAsMeshes known = *pair.meshes;
    known.relation = as_meshes->relation(known);
    // of surfaces no more is known than that they meet
    if (known.relation.relation != Relation::meeting) pair.relation = known.relation.relation;
    pair.meshes = std::make_shared<const PairAsMeshes>(known);
  } else {
    pair.relation = relation_of(pair, a, b);
  }
  if (question.touching_allowed && pair.relation == Relation::touching) {
    pair.counts = false;
    ++counts.touching_only;
  }
}

bool is_listed_before(const PartPair& p, const PartPair& q) {
  return std::tie(p.body_a, p.body_b, p.part_a, p.part_b) < std::tie(q.body_a, q.body_b, q.part_a, q.part_b);
}

}  // namespace sunder::scene
