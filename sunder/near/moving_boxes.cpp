#include <sunder/base/contract.h>
#include <sunder/near/moving_boxes.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sunder {

namespace {

constexpr double moves_ahead = 8, most_of_side = 0.25;

double clamped(double x) {
  constexpr double most = std::numeric_limits<double>::max();
  return std::clamp(x, -most, most);
}

// Twice the middle would overflow.
double middle(const Box3& box, std::size_t k) { return clamped(box.low[k]) / 2 + clamped(box.high[k]) / 2; }

double greatest_side(const Box3& box) {
  return std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
}

Box3 box_of_nothing() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

}  // namespace

MovingBoxes::MovingBoxes(std::span<const Box3> boxes, Wanted wanted)
    : wanted_(std::move(wanted)),
      boxes_(boxes.begin(), boxes.end()),
      order_(boxes.size()),
      place_(boxes.size()),
      wide_(boxes.begin(), boxes.end()),
      change_(boxes.size()) {
  SUNDER_REQUIRE(boxes.size() < std::size_t{1} << 31);
  std::iota(order_.begin(), order_.end(), 0u);
  place_ = changed_ = change_ = order_;
  before_ = wide_;
  leaves_ = std::bit_ceil(std::max<std::size_t>(1, (boxes.size() + leaf_size - 1) / leaf_size));
  nodes_.resize(2 * leaves_);
  build();
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
  Box3& wide = wide_[place_[i]];
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
  refit();
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

// Leaves get the boxes in the order of their middles, halved along the widest axis again and again.
void MovingBoxes::build() {
  const std::vector<Box3> wide = wide_;
  const std::vector<std::uint32_t> place = place_;
  std::sort(order_.begin(), order_.end());  // so that the tree depends on the boxes alone
  split(0, leaves_);
  for (std::uint32_t p = 0; p < order_.size(); ++p) {
    wide_[p] = wide[place[order_[p]]];
    place_[order_[p]] = p;
  }
  refit();
}

// place_ and wide_ are still as before.
void MovingBoxes::split(std::size_t first_leaf, std::size_t leaves) {
  const auto at = [&](std::size_t leaf) { return order_.begin() + static_cast<std::ptrdiff_t>(begin_of(leaf)); };
  if (leaves < 2) return;
  const auto begin = at(first_leaf), middle_of_all = at(first_leaf + leaves / 2), end = at(first_leaf + leaves);
  if (begin == end) return;
  std::size_t axis = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    double least = std::numeric_limits<double>::max(), greatest = std::numeric_limits<double>::lowest();
    for (auto i = begin; i != end; ++i) {
      const double m = middle(wide(*i), k);
      least = std::min(least, m);
      greatest = std::max(greatest, m);
    }
    const double spread = greatest / 2 - least / 2;  // halves do not overflow
    if (spread > most) most = spread, axis = k;
  }
  if (middle_of_all != end) {
    std::nth_element(begin, middle_of_all, end, [&](std::uint32_t i, std::uint32_t j) {
      const double p = middle(wide(i), axis), q = middle(wide(j), axis);
      return p != q ? p < q : i < j;
    });
  }
  split(first_leaf, leaves / 2);
  split(first_leaf + leaves / 2, leaves / 2);
}

void MovingBoxes::refit() {
  for (std::size_t leaf = 0; leaf < leaves_; ++leaf) {
    Box3 all = box_of_nothing();
    for (std::size_t p = begin_of(leaf); p < begin_of(leaf + 1); ++p) all = hull(all, wide_[p]);
    nodes_[leaves_ + leaf] = all;
  }
  for (std::size_t k = leaves_; k-- > 1;) nodes_[k] = hull(nodes_[2 * k], nodes_[2 * k + 1]);
}

// What the wide box of this change meets.
void MovingBoxes::search(std::size_t change) {
  constexpr std::uint64_t few = 128, a_hit = 8, as_much_as_building = 32;
  const std::uint32_t i = changed_[change];
  const Box3 box = wide(i), before = before_[change];
  std::uint64_t looks = 0, hits = 0;
  stack_.assign(1, 1);
  while (!stack_.empty()) {
    const std::size_t node = stack_.back();
    stack_.pop_back();
    ++looks;
    if (!meet(nodes_[node], box)) continue;
    if (node < leaves_) {
      stack_.push_back(2 * node + 1);
      stack_.push_back(2 * node);
      continue;
    }
    const std::size_t leaf = node - leaves_, end = begin_of(leaf + 1);
    for (std::size_t p = begin_of(leaf); p < end; ++p) {
      ++looks;
      if (!meet(wide_[p], box)) continue;
      ++hits;
      consider(i, order_[p], before);
    }
  }
  looks_ += looks;
  wasted_ += looks - std::min(looks, few + a_hit * hits);
  if (wasted_ > as_much_as_building * boxes_.size()) {
    wasted_ = 0;
    build();
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
