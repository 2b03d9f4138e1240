#include <sunder/base/contract.h>
#include <sunder/near/box_tree.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

namespace sunder {

namespace {

double clamped(double x) {
  constexpr double most = std::numeric_limits<double>::max();
  return std::clamp(x, -most, most);
}

// Twice the middle would overflow.
double middle(const Box3& box, std::size_t k) { return clamped(box.low[k]) / 2 + clamped(box.high[k]) / 2; }

Box3 box_of_nothing() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes, std::span<const std::uint32_t> groups)
    : order_(boxes.size()), boxes_(boxes.begin(), boxes.end()), groups_(groups.begin(), groups.end()) {
  SUNDER_REQUIRE(boxes.size() < std::size_t{1} << 31);
  SUNDER_REQUIRE(groups.empty() || groups.size() == boxes.size());
  std::iota(order_.begin(), order_.end(), 0u);
  place_ = order_;
  leaves_ = std::bit_ceil(std::max<std::size_t>(1, (boxes.size() + leaf_size - 1) / leaf_size));
  nodes_.resize(2 * leaves_);
  build();
}

// Leaves get the boxes in the order of their middles, halved along the widest axis again and again.
void BoxTree::build() {
  const std::vector<Box3> boxes = boxes_;
  const std::vector<std::uint32_t> place = place_;
  std::sort(order_.begin(), order_.end());  // so that the tree depends on the boxes alone
  split(0, leaves_);
  for (std::uint32_t p = 0; p < order_.size(); ++p) {
    boxes_[p] = boxes[place[order_[p]]];
    place_[order_[p]] = p;
  }
  refit();
  note_groups();
}

// place_ and boxes_ are still as before.
void BoxTree::split(std::size_t first_leaf, std::size_t leaves) {
  const auto at = [&](std::size_t leaf) { return order_.begin() + static_cast<std::ptrdiff_t>(begin_of(leaf)); };
  if (leaves < 2) return;
  const auto begin = at(first_leaf), middle_of_all = at(first_leaf + leaves / 2), end = at(first_leaf + leaves);
  if (begin == end) return;
  std::size_t axis = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    double least = std::numeric_limits<double>::max(), greatest = std::numeric_limits<double>::lowest();
    for (auto i = begin; i != end; ++i) {
      const double m = middle(box(*i), k);
      least = std::min(least, m);
      greatest = std::max(greatest, m);
    }
    const double spread = greatest / 2 - least / 2;  // halves do not overflow
    if (spread > most) most = spread, axis = k;
  }
  if (middle_of_all != end) {
    std::nth_element(begin, middle_of_all, end, [&](std::uint32_t i, std::uint32_t j) {
      const double p = middle(box(i), axis), q = middle(box(j), axis);
      return p != q ? p < q : i < j;
    });
  }
  split(first_leaf, leaves / 2);
  split(first_leaf + leaves / 2, leaves / 2);
}

void BoxTree::refit() {
  for (std::size_t leaf = 0; leaf < leaves_; ++leaf) {
    Box3 all = box_of_nothing();
    for (std::size_t p = begin_of(leaf); p < begin_of(leaf + 1); ++p) all = hull(all, boxes_[p]);
    nodes_[leaves_ + leaf] = all;
  }
  for (std::size_t k = leaves_; k-- > 1;) nodes_[k] = hull(nodes_[2 * k], nodes_[2 * k + 1]);
}

void BoxTree::note_groups() {
  if (groups_.empty()) return;
  node_groups_.assign(2 * leaves_, no_group);
  for (std::size_t leaf = 0; leaf < leaves_; ++leaf) {
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(begin_of(leaf));
    const auto end = order_.begin() + static_cast<std::ptrdiff_t>(begin_of(leaf + 1));
    if (first == end) continue;
    const std::uint32_t group = groups_[*first];
    if (std::all_of(first, end, [&](std::uint32_t i) { return groups_[i] == group; })) {
      node_groups_[leaves_ + leaf] = group;
    }
  }
  for (std::size_t k = leaves_; k-- > 1;) {
    if (node_groups_[2 * k] == node_groups_[2 * k + 1]) node_groups_[k] = node_groups_[2 * k];
  }
}

}  // namespace sunder
