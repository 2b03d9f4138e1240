#include <sunder/base/contract.h>
#include <sunder/near/moving_boxes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sunder {

namespace {

constexpr double moves_ahead = 8, most_of_side = 0.25;

double greatest_side(const Box3& box) {
  return std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
}

}  // namespace

MovingBoxes::MovingBoxes(std::span<const Box3> boxes, Wanted wanted)
    : wanted_(std::move(wanted)),
      boxes_(boxes.begin(), boxes.end()),
      tree_(boxes),
      changed_(boxes.size()),
      before_(boxes.begin(), boxes.end()) {
  std::iota(changed_.begin(), changed_.end(), 0u);
  change_ = changed_;
  update();
}

// A margin that is not a number, or not less than it may be, is none.
Box3 MovingBoxes::widened(const Box3& box, const Box3& before) const {
  const double most = most_of_side * greatest_side(box);
  Box3 wide = box;
  for (std::size_t k = 0; k < 3; ++k) {
    const double step = std::max(std::fabs(box.low[k] - before.low[k]), std::fabs(box.high[k] - before.high[k]));
    if (!(step < most)) continue;
    const double margin = std::min(moves_ahead * step, most);
    wide.low[k] = box.low[k] - margin;
    wide.high[k] = box.high[k] + margin;
  }
  return wide;
}

void MovingBoxes::move(std::uint32_t i, const Box3& box) {
  SUNDER_REQUIRE(i < boxes_.size());
  const Box3 last = std::exchange(boxes_[i], box);
  Box3& wide = tree_.box(i);
  if (holds(wide, box)) {
    // Unless the box has become much smaller.
    const double most = 2 * most_of_side * greatest_side(box);
    bool is_near = true;
    for (std::size_t k = 0; k < 3; ++k) {
      is_near = is_near && !(box.low[k] - wide.low[k] > most) && !(wide.high[k] - box.high[k] > most);
    }
    if (is_near) return;
  }
  if (change_[i] == none) {
    change_[i] = static_cast<std::uint32_t>(changed_.size());
    changed_.push_back(i);
    before_.push_back(wide);
  }
  wide = widened(box, last);
}

void MovingBoxes::update() {
  fresh_.clear();
  if (changed_.empty()) return;
  drop_parted();
  tree_.refit();
  for (std::size_t c = 0; c < changed_.size(); ++c) search(c);
  for (const std::uint32_t i : changed_) change_[i] = none;
  changed_.clear();
  before_.clear();
  is_new_ = false;
}

void MovingBoxes::drop_parted() {
  std::erase_if(pairs_, [&](const Pair& pair) {
    if (change_[pair.i] == none && change_[pair.j] == none) return false;
    if (meet(wide(pair.i), wide(pair.j))) return false;
    free_.push_back(pair.slot);
    return true;
  });
}

// What the wide box of this change meets.
void MovingBoxes::search(std::size_t change) {
  constexpr std::uint64_t few = 128, a_hit = 8, as_much_as_building = 32;
  const std::uint32_t i = changed_[change];
  const Box3 box = wide(i), before = before_[change];
  std::uint64_t hits = 0;
  const std::uint64_t looks = tree_.for_each_meeting(box, BoxTree::no_group, [&](std::uint32_t j) {
    ++hits;
    consider(i, j, before);
  });
  looks_ += looks;
  wasted_ += looks - std::min(looks, few + a_hit * hits);
  if (wasted_ > as_much_as_building * boxes_.size()) {
    wasted_ = 0;
    tree_.build();
  }
}

// The wide boxes of i, which has changed, and j meet. A pair that met before is there already; where both have changed,
// the one that comes first in changed_ tells of it.
void MovingBoxes::consider(std::uint32_t i, std::uint32_t j, const Box3& before) {
  if (i == j) return;
  const std::uint32_t other = change_[j];
  if (other != none && other < change_[i]) return;
  if (!is_new_ && meet(before, other == none ? wide(j) : before_[other])) return;
  const auto [low, high] = std::minmax(i, j);
  if (!wanted_(low, high)) return;
  std::uint32_t slot = static_cast<std::uint32_t>(slots_);
  if (free_.empty()) {
    ++slots_;
  } else {
    slot = free_.back();
    free_.pop_back();
  }
  pairs_.push_back({low, high, slot});
  fresh_.push_back(slot);
}

}  // namespace sunder
