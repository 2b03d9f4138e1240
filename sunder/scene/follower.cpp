#include <sunder/base/contract.h>
#include <sunder/base/lanes.h>
#include <sunder/scene/follower.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace sunder::scene {

namespace {

// Where what parted them now can be kept as a parting, it need not be kept twice.
void keep_parting(const Part& a, PairWarmStart& last, std::span<solid::KeptParting> kept) {
  if (last.partings_count == 0) return;
  const auto& [direction, extreme_a, extreme_b] = last.partings[0];
  if (solid::keep_parting(a.shape.core(), direction, extreme_a, extreme_b, kept)) last.partings_count = 0;
}

}  // namespace

// They hold the box: a float is within 2^-24 of what is rounded to it, or 2^-150; the sums cost 2^-24 each, and 2^-22
// is added. What is beyond all floats becomes the last of them, or infinite on the outer side.
Follower::FlatBox Follower::flat_box(const Box3& box) {
  static constexpr float part = 0x1p-22f, tiny = 0x1p-120f;
  static constexpr double most = static_cast<double>(std::numeric_limits<float>::max());
  std::array<Lanes, 3> ends = std::bit_cast<std::array<Lanes, 3>>(box);
  for (Lanes& of : ends) of = smaller_of(greater_of(of, Lanes{-most, -most}), Lanes{most, most});
  const auto rounded = [&](std::size_t k) { return static_cast<float>(ends[k / 2][k % 2]); };
  const FloatLanes low{rounded(0), rounded(1), rounded(2), 0}, high{rounded(3), rounded(4), rounded(5), 0};
  const auto beyond = [](FloatLanes x) { return absolute(x) * part + tiny; };
  return {low - beyond(low), high + beyond(high)};
}

// Without branches: which boxes meet, of many, is hard to predict.
inline bool Follower::have_common_point(const FlatBox& a, const FlatBox& b) {
  return bits_of_four((a.low <= b.high) & (b.low <= a.high)) == 15;
}
inline bool Follower::have_common_point(const Box3& a, const Box3& b) {
  const Lanes third_low{a.low.z, b.low.z}, third_high{b.high.z, a.high.z};
  return bits_of(is_at_most(lanes_at(&a.low.x), lanes_at(&b.high.x)) &
                 is_at_most(lanes_at(&b.low.x), lanes_at(&a.high.x)) & is_at_most(third_low, third_high)) == 3;
}

Follower::Follower(std::span<const Body> bodies, const Question& question)
    : bodies_(bodies.begin(), bodies.end()),
      question_(question),
      asks_warmly_(question.method == solid::polyhedron_polyhedron),
      members_(std::make_shared<const Members>(bodies, question.allowed)),
      is_placed_(members_->size()),
      boxes_(members_->size()) {
  list_few();
  for (std::uint32_t i = 0; i < part_count(); ++i) {
    rigid_.emplace_back(members_->part(std::span<const Body>(bodies_), i).shape.core());
  }
  if (!few_.empty()) {
    kept_of_pair_ = most_kept_of_few;
    flat_boxes_.resize(part_count());
  }
  forget();
}

void Follower::list_few() {
  Counts counts;
  members_->complete(counts);
  // Of more parts than that, to look through their pairs for those few would cost more.
  if (counts.pairs - counts.allowed > few || part_count() > 2 * few) return;
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
  kept_.assign(few_.size() * kept_of_pair_, {});
  placed_.clear();
  for (std::uint32_t i = 0; i < part_count(); ++i) placed_.push_back(i);
  is_placed_.assign(part_count(), true);
}

// Pairs, of which meeting_ numbers those whose boxes meet; and in last_ and kept_ what is known of them.
std::span<const MovingBoxes::Pair> Follower::follow_near() {
  const auto keep_those_of = [this](std::span<const MovingBoxes::Pair> pairs, const auto& boxes) {
    meeting_.resize(pairs.size() + 1);
    std::size_t count = 0;
    for (std::uint32_t k = 0; k < pairs.size(); ++k) {
      meeting_[count] = k;
      count += have_common_point(boxes[pairs[k].i], boxes[pairs[k].j]);
    }
    meeting_.resize(count);
    return pairs;
  };
  if (!few_.empty()) return keep_those_of(few_, flat_boxes_);
  if (near_) {
    near_->update();
  } else {
    near_.emplace(boxes_,
                  [members = members_](std::uint32_t i, std::uint32_t j) { return members->are_asked_about(i, j); });
  }
  last_.resize(near_->slot_count());
  kept_.resize(near_->slot_count() * kept_of_pair_);
  for (const std::uint32_t slot : near_->fresh()) {
    last_[slot] = {};
    std::ranges::fill(kept_of(slot), solid::KeptParting{});
  }
  return keep_those_of(near_->pairs(), boxes_);
}

void Follower::look_at(const MovingBoxes::Pair& of) {
  const auto& [i, j, slot] = of;
  if (asks_warmly_ && part_again(rigid_[i], rigid_[j], kept_of(slot))) {
    ++answer_.counts.by_method;
    return;
  }
  const std::span<const Body> bodies(bodies_);
  const Part &a = members_->part(bodies, i), &b = members_->part(bodies, j);
  solid::RoundAnswer answer = answer_of(a, b, question_, last_[slot]);
  if (answer.verdict() == Verdict::apart) {
    if (asks_warmly_) keep_parting(a, last_[slot], kept_of(slot));
    ++answer_.counts.by_method;
    return;
  }
  // The boxes that meeting_pairs looks at first are tighter than the rough ones.
  if (answer.undecided() && apart_by_boxes(box_of(a), box_of(b))) return;
  PartPair pair = members_->pair(i, j);
  pair.answer = std::move(answer);
  look_closer(pair, a, b);
  count_answer(pair, a, b, question_, answer_.counts);
  if (pair.verdict() != Verdict::apart) list(std::move(pair));
}

// The list grows by a quarter, as it is most of what a follower of many pairs holds.
void Follower::list(PartPair&& pair) {
  std::vector<PartPair>& pairs = answer_.pairs;
  if (pairs.size() == pairs.capacity()) pairs.reserve(pairs.size() + pairs.size() / 4 + 4);
  pairs.push_back(std::move(pair));
}

const Answer& Follower::ask() {
  const std::span<const Body> bodies(bodies_);
  for (const std::uint32_t i : placed_) {
    is_placed_[i] = false;
    const Part& part = members_->part(bodies, i);
    boxes_[i] = rough_box_of(part);
    if (!few_.empty()) flat_boxes_[i] = flat_box(boxes_[i]);
    rigid_[i].place(part.pose);
    if (near_) near_->move(i, boxes_[i]);
  }
  placed_.clear();

  answer_.pairs.clear();
  answer_.counts = {};
  const std::span<const MovingBoxes::Pair> pairs = follow_near();
  for (const std::uint32_t k : meeting_) look_at(pairs[k]);
  std::sort(answer_.pairs.begin(), answer_.pairs.end(), is_listed_before);
  members_->complete(answer_.counts);
  return answer_;
}

}  // namespace sunder::scene
