#include <sunder/scene/part_questions.h>
#include <sunder/solid/mesh/mesh_relation.h>

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

std::optional<MeshesOfPair> meshes_of(const Part& a, const Part& b) {
  if (a.mesh == nullptr && b.mesh == nullptr) return std::nullopt;
  const solid::Mesh *mesh_a = mesh_of(a), *mesh_b = mesh_of(b);
  if (mesh_a == nullptr || mesh_b == nullptr) return std::nullopt;
  if (!can_be_placed(*mesh_a, a.pose) || !can_be_placed(*mesh_b, b.pose)) return std::nullopt;
  return MeshesOfPair{*mesh_a, *mesh_b};
}

void look_closer(PartPair& pair, const Part& a, const Part& b) {
  if (!pair.answer.meet()) return;
  if (const auto meshes = meshes_of(a, b)) {
    pair.meshes = std::make_shared<const PairAsMeshes>(PairAsMeshes{mesh_mesh(meshes->a, a.pose, meshes->b, b.pose)});
  }
}

void count_answer(PartPair& pair, const Part& a, const Part& b, const Question& question, Counts& counts) {
  ++counts.by_method;
  if (pair.meshes && !pair.meet() && !(mesh_of(a)->is_closed() && mesh_of(b)->is_closed())) ++counts.surfaces_alone;
  if (pair.undecided()) ++counts.undecided;
  if (!pair.meet()) return;
  ++counts.meeting;
  pair.counts = true;
  if (!question.contacts && !question.touching_allowed) return;
  if (pair.meshes) {
    PairAsMeshes known = *pair.meshes;
    known.relation = mesh_relation(*mesh_of(a), a.pose, *mesh_of(b), b.pose, known.answer);
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
