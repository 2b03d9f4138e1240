#include <sunder/scene/part_questions.h>
#include <sunder/solid/pair/placed.h>

#include <tuple>

namespace sunder::scene {

WorldBox box_of(const Part& part) { return world_box(solid::Placed(part.shape, part.pose)); }
Box3 rough_box_of(const Part& part) { return rough_world_box(solid::Placed(part.shape, part.pose)); }

PairAnswer pair_answer(const Part& a, const Part& b, const Question& question) {
  return question.method(a.shape, a.pose, b.shape, b.pose);
}

PairAnswer pair_answer(const Part& a, const Part& b, const Question& question, PairWarmStart& last) {
  if (question.method != solid::polyhedron_polyhedron) return pair_answer(a, b, question);
  return solid::polyhedron_polyhedron_warm(a.shape, a.pose, b.shape, b.pose, last);
}

void count_answer(PartPair& pair, const Part& a, const Part& b, const Question& question, Counts& counts) {
  ++counts.by_method;
  if (!pair.answer.meet()) return;
  ++counts.meeting;
  pair.counts = true;
  if (!question.contacts && !question.touching_allowed) return;
  pair.contact = solid::polyhedron_polyhedron_contact(a.shape, a.pose, b.shape, b.pose);
  if (question.touching_allowed && pair.contact == Contact::touching) {
    pair.counts = false;
    ++counts.touching_only;
  }
}

bool is_listed_before(const PartPair& p, const PartPair& q) {
  return std::tie(p.body_a, p.body_b, p.part_a, p.part_b) < std::tie(q.body_a, q.body_b, q.part_a, q.part_b);
}

}  // namespace sunder::scene
