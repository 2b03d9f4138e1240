#include <sunder/base/contract.h>
#include <sunder/base/lanes.h>
#include <sunder/scene/follower.h>

#include <algorithm>
#include <utility>

namespace sunder::scene {

namespace {

// As meet, without branches: which boxes meet, of many, is hard to predict.
bool have_common_point(const Box3& a, const Box3& b) {
  const Lanes third_low{a.low.z, b.low.z}, third_high{b.high.z, a.high.z};
  return bits_of(is_at_most(lanes_at(&a.low.x), lanes_at(&b.high.x)) &
                 is_at_most(lanes_at(&b.low.x), lanes_at(&a.high.x)) & is_at_most(third_low, third_high)) == 3;
}

}  // namespace

Follower::Follower(std::span<const Body> bodies, const Question& question)
    : bodies_(bodies.begin(), bodies.end()),
      question_(question),
      members_(std::make_shared<const Members>(bodies, question.allowed)),
      boxes_(members_->size()),
      is_placed_(members_->size()) {
  list_few();
  forget();
}

void Follower::list_few() {
  Counts counts;
  members_->complete(counts);
  if (counts.pairs - counts.allowed > few) return;
  for (std::uint32_t j = 0; j < part_count(); ++j) {
    for (std::uint32_t i = 0; i < j; ++i) {
      if (members_->are_asked_about(i, j)) few_.push_back({i, j, static_cast<std::uint32_t>(few_.size())});
    }
  }
}

void Follower::place(std::uint32_t part, const solid::Pose& pose) {
  SUNDER_REQUIRE(part < part_count());
  Part& placed = members_->part(std::span(bodies_), part);
  require_rigid(placed.shape, pose);
  placed.pose = pose;
  if (is_placed_[part]) return;
  is_placed_[part] = true;
  placed_.push_back(part);
}

void Follower::forget() {
  near_.reset();
  last_.assign(few_.size(), {});
  placed_.clear();
  for (std::uint32_t i = 0; i < part_count(); ++i) placed_.push_back(i);
  is_placed_.assign(part_count(), true);
}

// The pairs whose boxes may meet, and in last_ their last answers.
std::span<const MovingBoxes::Pair> Follower::follow_near() {
  if (!few_.empty()) return few_;
  if (near_) {
    near_->update();
  } else {
    near_.emplace(boxes_,
                  [members = members_](std::uint32_t i, std::uint32_t j) { return members->are_asked_about(i, j); });
  }
  last_.resize(near_->slot_count());
  for (const std::uint32_t slot : near_->fresh()) last_[slot] = {};
  return near_->pairs();
}

void Follower::look_at_round(std::uint32_t i, std::uint32_t j) {
  const std::span<const Body> bodies(bodies_);
  const Part &a = members_->part(bodies, i), &b = members_->part(bodies, j);
  PartPair pair = members_->pair(i, j);
  take_round_answer(pair, a, b);
  count_answer(pair, a, b, question_, answer_.counts);
  if (pair.meet() || pair.undecided()) answer_.pairs.push_back(std::move(pair));
}

const Answer& Follower::ask() {
  const std::span<const Body> bodies(bodies_);
  for (const std::uint32_t i : placed_) {
    is_placed_[i] = false;
    boxes_[i] = rough_box_of(members_->part(bodies, i));
    if (near_) near_->move(i, boxes_[i]);
  }
  placed_.clear();

  answer_.pairs.clear();
  answer_.counts = {};
  for (const auto& [i, j, slot] : follow_near()) {
    if (!have_common_point(boxes_[i], boxes_[j])) continue;
    const Part &a = members_->part(bodies, i), &b = members_->part(bodies, j);
    if (!are_polyhedra(a, b)) {
      look_at_round(i, j);
      continue;
    }
    PairAnswer answer = pair_answer(a, b, question_, last_[slot]);
    if (!answer.meet()) {
      ++answer_.counts.by_method;
      continue;
    }
    PartPair& pair = answer_.pairs.emplace_back(members_->pair(i, j));
    pair.answer = std::move(answer);
    count_answer(pair, a, b, question_, answer_.counts);
  }
  std::sort(answer_.pairs.begin(), answer_.pairs.end(), is_listed_before);
  members_->complete(answer_.counts);
  return answer_;
}

}  // namespace sunder::scene
