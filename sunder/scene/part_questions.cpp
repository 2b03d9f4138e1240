#include <sunder/scene/part_questions.h>
#include <sunder/solid/search/placed.h>

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

WorldBox box_of(const Part& part) {
  if (part.shape.is_polyhedron()) return world_box(solid::Placed(part.shape.core(), part.pose));
  return world_box(PlacedRound(part.shape, part.pose));
}

Box3 rough_box_of(const Part& part) {
  if (part.shape.is_polyhedron()) return rough_world_box(solid::Placed(part.shape.core(), part.pose));
  return rough_world_box(PlacedRound(part.shape, part.pose));
}

bool are_polyhedra(const Part& a, const Part& b) { return a.shape.is_polyhedron() && b.shape.is_polyhedron(); }

solid::RoundAnswer answer_of(const Part& a, const Part& b, const Question& question) {
  if (!are_polyhedra(a, b)) return round_round(a.shape, a.pose, b.shape, b.pose);
  return solid::round_answer(question.method(a.shape.core(), a.pose, b.shape.core(), b.pose));
}

solid::RoundAnswer answer_of(const Part& a, const Part& b, const Question& question, PairWarmStart& last) {
  if (question.method != solid::polyhedron_polyhedron || !are_polyhedra(a, b)) return answer_of(a, b, question);
  return solid::round_answer(solid::polyhedron_polyhedron_warm(a.shape.core(), a.pose, b.shape.core(), b.pose, last));
}

void take_boxes(PartPair& pair, const Part& a, const Part& b, const Separation& boxes) {
  pair.by_boxes = true;
  if (are_polyhedra(a, b)) {
    pair.answer.evidence = boxes;
  } else {
    pair.answer.evidence = solid::SeparatingDirection{boxes.direction.given};
  }
}

void count_answer(PartPair& pair, const Part& a, const Part& b, const Question& question, Counts& counts) {
  ++counts.by_method;
  if (pair.undecided()) ++counts.undecided;
  if (!pair.meet()) return;
  ++counts.meeting;
  pair.counts = true;
  if (!question.contacts && !question.touching_allowed) return;
  pair.relation = relation_of(pair, a, b);
  if (question.touching_allowed && pair.relation == Relation::touching) {
    pair.counts = false;
    ++counts.touching_only;
  }
}

bool is_listed_before(const PartPair& p, const PartPair& q) {
  return std::tie(p.body_a, p.body_b, p.part_a, p.part_b) < std::tie(q.body_a, q.body_b, q.part_a, q.part_b);
}

}  // namespace sunder::scene
