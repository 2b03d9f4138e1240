#include <sunder/base/contract.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_questions.h>
#include <sunder/scene/sweep.h>
#include <sunder/solid/pair/polyhedron_polyhedron_sweep.h>

#include <algorithm>
#include <array>

namespace sunder::scene {

namespace {

Box3 both(const Box3& p, const Box3& q) {
  Box3 box = p;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(p.low[k], q.low[k]);
    box.high[k] = std::max(p.high[k], q.high[k]);
  }
  return box;
}

class Sweep {
 public:
  Sweep(std::span<const Body> begin, std::span<const Body> end, const Question& question)
      : bodies_{begin, end}, members_(begin, question.allowed) {
    for (std::uint32_t i = 0; i < members_.size(); ++i) {
      const Part &first = part(i, 0), &last = part(i, 1);
      for (const Part* at : {&first, &last}) require_rigid(at->shape, at->pose);
      goes_straight_.push_back(first.shape.is_polyhedron() && is_translation(first.pose, last.pose));
      for (std::size_t k = 0; k < 2; ++k) boxes_[k].push_back(rough_box_of(part(i, k)));
    }
  }

  SweptAnswer answer() {
    for (std::uint32_t j = 0; j < members_.size(); ++j) {
      for (std::uint32_t i = 0; i < j; ++i) {
        if (members_.are_asked_about(i, j)) look_at(i, j);
      }
    }
    std::sort(answer_.pairs.begin(), answer_.pairs.end(), [](const SweptPair& p, const SweptPair& q) {
      return std::array{p.body_a, p.body_b, p.part_a, p.part_b} < std::array{q.body_a, q.body_b, q.part_a, q.part_b};
    });
    Counts all;
    members_.complete(all);
    answer_.counts.pairs = all.pairs;
    answer_.counts.allowed = all.allowed;
    return std::move(answer_);
  }

 private:
  const Part& part(std::uint32_t i, std::size_t at) const { return members_.part(bodies_[at], i); }

  void look_at(std::uint32_t i, std::uint32_t j) {
    if (!goes_straight_[i] || !goes_straight_[j]) return look_at_ends(i, j);
    // All of a way that is straight is in the hull of both ends, and so in the box around their boxes.
    if (!meet(both(boxes_[0][i], boxes_[1][i]), both(boxes_[0][j], boxes_[1][j]))) {
      ++answer_.counts.by_boxes;
      return;
    }
    ++answer_.counts.by_method;
    const solid::ConvexPolyhedron &a = part(i, 0).shape.core(), &b = part(j, 0).shape.core();
    const solid::Translation of_a(part(i, 0).pose, part(i, 1).pose), of_b(part(j, 0).pose, part(j, 1).pose);
    const solid::SweepAnswer swept = polyhedron_polyhedron_sweep(a, of_a, b, of_b);
    if (!swept.meet()) return;
    if (swept.found == solid::SweepAnswer::Found::at_begin) return list(i, j, true, 0.0);
    list(i, j, true, polyhedron_polyhedron_first_contact(a, of_a, b, of_b)->about());
  }

  void look_at_ends(std::uint32_t i, std::uint32_t j) {
    ++answer_.counts.at_ends_only;
    bool is_undecided = false;
    for (std::size_t at = 0; at < 2; ++at) {
      if (!meet(boxes_[at][i], boxes_[at][j])) continue;
      PartPair pair = members_.pair(i, j);
      const Part &a = part(i, at), &b = part(j, at);
      if (are_polyhedra(a, b)) {
        pair.answer = pair_answer(a, b, {});
      } else {
        take_round_answer(pair, a, b);
      }
      if (pair.meet()) return list(i, j, false, static_cast<double>(at));
      is_undecided = is_undecided || pair.undecided();
    }
    answer_.counts.undecided += is_undecided;
  }

  void list(std::uint32_t i, std::uint32_t j, bool all_the_way, const Interval& time) {
    const PartPair pair = members_.pair(i, j);
    answer_.pairs.push_back({pair.body_a, pair.body_b, pair.part_a, pair.part_b, all_the_way, time});
  }

  std::array<std::span<const Body>, 2> bodies_;
  Members members_;
  std::vector<bool> goes_straight_;
  std::array<std::vector<Box3>, 2> boxes_;  // of each part at both ends
  SweptAnswer answer_;
};

}  // namespace

SweptAnswer meeting_on_the_way(std::span<const Body> begin, std::span<const Body> end, const Question& question) {
  SUNDER_REQUIRE(begin.size() == end.size());
  return Sweep(begin, end, question).answer();
}

}  // namespace sunder::scene
