#include <sunder/scene/part_questions.h>
#include <sunder/solid/search/placed.h>

#include <memory>
#include <tuple>
#include <utility>

namespace sunder::scene {

namespace {

using solid::PlacedRound;

Contact contact_of(const PartPair& pair, const Part& a, const Part& b) {
  if (!pair.round) return solid::polyhedron_polyhedron_contact(a.shape.core(), a.pose, b.shape.core(), b.pose);
  const PlacedRound in_a(a.shape, a.pose), in_b(b.shape, b.pose);
  return round_round_contact(in_a, in_b, *pair.round).contact.value_or(Contact::none);
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

PairAnswer pair_answer(const Part& a, const Part& b, const Question& question) {
  return question.method(a.shape.core(), a.pose, b.shape.core(), b.pose);
}

PairAnswer pair_answer(const Part& a, const Part& b, const Question& question, PairWarmStart& last) {
  if (question.method != solid::polyhedron_polyhedron) return pair_answer(a, b, question);
  return solid::polyhedron_polyhedron_warm(a.shape.core(), a.pose, b.shape.core(), b.pose, last);
}

void take_round_answer(PartPair& pair, const Part& a, const Part& b) {
  solid::RoundAnswer answer = round_round(a.shape, a.pose, b.shape, b.pose);
  pair.answer.decided_by = answer.decided_by;
  pair.answer.cost = answer.cost;
  pair.round = std::make_shared<const solid::RoundEvidence>(std::move(answer.evidence));
}

void take_boxes(PartPair& pair, const Part& a, const Part& b, const PairCertificate& certificate) {
  pair.by_boxes = true;
  if (are_polyhedra(a, b)) {
    pair.answer.evidence = certificate;
    return;
  }
  solid::RoundEvidence evidence;
  evidence.verdict = Verdict::apart;
  evidence.direction = certificate.direction.given;
  pair.round = std::make_shared<const solid::RoundEvidence>(std::move(evidence));
}

void count_answer(PartPair& pair, const Part& a, const Part& b, const Question& question, Counts& counts) {
  ++counts.by_method;
  if (pair.undecided()) ++counts.undecided;
  if (!pair.meet()) return;
  ++counts.meeting;
  pair.counts = true;
  if (!question.contacts && !question.touching_allowed) return;
  pair.contact = contact_of(pair, a, b);
  if (question.touching_allowed && pair.contact == Contact::touching) {
    pair.counts = false;
    ++counts.touching_only;
  }
}

bool is_listed_before(const PartPair& p, const PartPair& q) {
  return std::tie(p.body_a, p.body_b, p.part_a, p.part_b) < std::tie(q.body_a, q.body_b, q.part_a, q.part_b);
}

}  // namespace sunder::scene
