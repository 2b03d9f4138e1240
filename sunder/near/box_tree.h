// A tree over many boxes: which of them meet a box, or are near it?
// Also called: bounding volume hierarchy (BVH), AABB tree, R-tree.
//
// The boxes are the leaves' members, eight a leaf at most; they are halved along the axis on which their middles are
// spread most, again and again. A node's box holds those of all below it. Ends may be infinite, not NaN. Boxes may have
// groups: one search leaves out all of one group, and nodes that hold nothing else.
#pragma once

#include <sunder/predicate/point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace sunder {

class BoxTree {
 public:
  static constexpr std::uint32_t no_group = 0xffffffff;

  // groups: of each box, or none at all. Requires fewer than 2^31 boxes. Cost: O(n log n).
  explicit BoxTree(std::span<const Box3> boxes, std::span<const std::uint32_t> groups = {});

  std::size_t size() const { return order_.size(); }
  const Box3& box(std::uint32_t i) const { return boxes_[place_[i]]; }
  // The boxes in the order of the leaves: neighbours are mostly near each other.
  std::span<const std::uint32_t> order() const { return order_; }

  // A box that is changed counts after refit(), which keeps the tree's shape, or build(), which makes it anew.
  Box3& box(std::uint32_t i) { return boxes_[place_[i]]; }
  void refit();  // O(n)
  void build();  // O(n log n)

  // Calls of_box(j) for each box that has a common point with this one, but for those of the group. Returns how many
  // boxes, of nodes and members, it looked at. Requires no_group where the boxes have none.
  template <class OfBox>
  std::uint64_t for_each_meeting(const Box3& box, std::uint32_t group, const OfBox& of_box) const;

  // Calls of_box(j, gap(box j)) for each box, but for those of the group, whose gap is at most `most`, which may become
  // less meanwhile; nearer nodes first. Requires that no box has a greater gap than one inside it. Returns as above.
  template <class Gap, class OfBox>
  std::uint64_t for_each_near(std::uint32_t group, const Gap& gap, const double& most, const OfBox& of_box) const;

 private:
  static constexpr std::size_t leaf_size = 8;
  static constexpr std::size_t deepest = 64;  // nodes that wait: two a level at most

  std::size_t begin_of(std::size_t leaf) const { return leaf * order_.size() / leaves_; }
  void split(std::size_t first_leaf, std::size_t leaves);
  void note_groups();
  bool holds_only(std::size_t node, std::uint32_t group) const {
    return group != no_group && !node_groups_.empty() && node_groups_[node] == group;
  }

  std::vector<std::uint32_t> order_;        // the boxes in the order of the leaves
  std::vector<std::uint32_t> place_;        // of each box in that order
  std::vector<Box3> boxes_;                 // in that order
  std::vector<Box3> nodes_;                 // node k has the children 2 k and 2 k + 1; leaf l is node leaves_ + l
  std::vector<std::uint32_t> groups_;       // of each box; or empty
  std::vector<std::uint32_t> node_groups_;  // of all below it; no_group where these differ, or there are none
  std::size_t leaves_ = 1;
};

template <class OfBox>
std::uint64_t BoxTree::for_each_meeting(const Box3& box, std::uint32_t group, const OfBox& of_box) const {
  std::uint64_t looks = 0;
  std::array<std::size_t, deepest> waiting;
  std::size_t count = 0;
  waiting[count++] = 1;
  while (count > 0) {
    const std::size_t node = waiting[--count];
    ++looks;
    if (!meet(nodes_[node], box) || holds_only(node, group)) continue;
    if (node < leaves_) {
      waiting[count++] = 2 * node + 1;
      waiting[count++] = 2 * node;
      continue;
    }
    const std::size_t leaf = node - leaves_, end = begin_of(leaf + 1);
    for (std::size_t p = begin_of(leaf); p < end; ++p) {
      ++looks;
      if (meet(boxes_[p], box) && (group == no_group || groups_[order_[p]] != group)) of_box(order_[p]);
    }
  }
  return looks;
}

template <class Gap, class OfBox>
std::uint64_t BoxTree::for_each_near(std::uint32_t group, const Gap& gap, const double& most,
                                     const OfBox& of_box) const {
  struct Waiting {
    std::size_t node;
    double gap;
  };
  const auto at = [&](std::size_t node) { return Waiting{node, gap(nodes_[node])}; };
  std::uint64_t looks = 1;
  std::array<Waiting, deepest> waiting;
  std::size_t count = 0;
  waiting[count++] = at(1);
  while (count > 0) {
    const Waiting here = waiting[--count];
    if (here.gap > most || holds_only(here.node, group)) continue;
    if (here.node < leaves_) {
      looks += 2;
      Waiting nearer = at(2 * here.node), further = at(2 * here.node + 1);
      if (further.gap < nearer.gap) std::swap(nearer, further);
      waiting[count++] = further;
      waiting[count++] = nearer;
      continue;
    }
    const std::size_t leaf = here.node - leaves_, end = begin_of(leaf + 1);
    for (std::size_t p = begin_of(leaf); p < end; ++p) {
      ++looks;
      if (group != no_group && groups_[order_[p]] == group) continue;
      const double found = gap(boxes_[p]);
      if (found <= most) of_box(order_[p], found);
    }
  }
  return looks;
}

}  // namespace sunder
