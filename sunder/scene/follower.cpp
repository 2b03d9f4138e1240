#include <sunder/base/contract.h>
#include <sunder/scene/follower.h>

#include <algorithm>
#include <utility>

namespace sunder::scene {

Follower::Follower(std::span<const Body> bodies, const Question& question)
    : bodies_(bodies.begin(), bodies.end()),
      question_(question),
      members_(std::make_shared<const Members>(bodies, question.allowed)),
      boxes_(members_->size()),
      is_placed_(members_->size()) {
  forget();
}

void Follower::place(std::uint32_t part, const solid::Pose& pose) {
  SUNDER_REQUIRE(part < part_count());
  members_->part(std::span(bodies_), part).pose = pose;
  if (is_placed_[part]) return;
  is_placed_[part] = true;
  placed_.push_back(part);
}

void Follower::forget() {
  near_.reset();
  last_.clear();
  std::fill(boxes_.begin(), boxes_.end(), TightBox());
  placed_.clear();
  for (std::uint32_t i = 0; i < part_count(); ++i) placed_.push_back(i);
  is_placed_.assign(part_count(), true);
}

const WorldBox& Follower::tight_box(std::uint32_t part) {
  TightBox& tight = boxes_[part];
  if (!tight.is_there) {
    tight.box = box_of(members_->part(std::span<const Body>(bodies_), part), tight.box);
    tight.is_there = true;
  }
  return tight.box;
}

const Answer& Follower::ask() {
  const std::span<const Body> bodies(bodies_);
  for (const std::uint32_t i : placed_) {
    is_placed_[i] = false;
    boxes_[i].is_there = false;
    if (near_) near_->move(i, rough_box_of(members_->part(bodies, i)));
  }
  placed_.clear();
  if (near_) {
    near_->update();
  } else {
    std::vector<Box3> boxes;
    for (std::uint32_t i = 0; i < part_count(); ++i) boxes.push_back(rough_box_of(members_->part(bodies, i)));
    near_.emplace(boxes,
                  [members = members_](std::uint32_t i, std::uint32_t j) { return members->are_asked_about(i, j); });
  }
  last_.resize(near_->slot_count());
  for (const std::uint32_t slot : near_->fresh()) last_[slot] = {};

  answer_.pairs.clear();
  answer_.counts = {};
  for (const auto& [i, j, slot] : near_->pairs()) {
    if (!meet(near_->box(i), near_->box(j)) || !meet(tight_box(i), tight_box(j))) continue;
    const Part &a = members_->part(bodies, i), &b = members_->part(bodies, j);
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
