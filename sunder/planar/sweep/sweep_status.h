// The segments that a sweep line cuts, from below to above: an ordered list as a B+ tree.
// Also called: sweep-line status structure.
//
// Leaves hold numbers of items in order, inner nodes the keys that part their children: copies, so that a search reads
// a few neighbouring cache lines a level. Whoever inserts knows the order: the list never compares by itself.
// Cost: an insertion asks for about log2 of the length comparisons; inserting, erasing and exchanging take time
// O(log N) for N insertions in all.
// Source: Bayer & McCreight 1972; nodes are dropped only when they are empty, which keeps the bounds for N insertions:
// a node at height h costs 30 that were made at height h - 1.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace sunder::planar {

template <class Key>
class SweepStatus {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Neighbours {
    std::uint32_t below = none, above = none;
  };

  // For items 0 .. keys.size() - 1. Keeps a reference to the keys.
  explicit SweepStatus(std::span<const Key> keys) : keys_(keys), leaf_of_(keys.size(), none) {}

  bool holds(std::uint32_t item) const { return leaf_of_[item] != none; }

  // Inserts an item that is not in the list, between those of which `is_above(key)`, "the new one is above this one",
  // is true and the rest. Requires that these stand first. Returns its neighbours.
  template <class IsAbove>
  Neighbours insert(std::uint32_t item, IsAbove&& is_above) {
    if (height_ == 0) start();
    const Place place = find(is_above);
    return put(place.leaf, place.at, item);
  }

  // Inserts an item that is not in the list just above an item of it, or, with none, below all.
  void insert_above(std::uint32_t below, std::uint32_t item) {
    if (height_ == 0) start();
    if (below != none) {
      put(leaf_of_[below], place_in(leaves_[leaf_of_[below]], below) + 1, item);
      return;
    }
    std::uint32_t node = root_;
    for (int level = height_; level > 1; --level) node = inners_[node].child[0];
    put(node, 0, item);
  }

  // Puts an item that is not in the list in the place of one that is.
  void replace(std::uint32_t old, std::uint32_t item) {
    const std::uint32_t node = leaf_of_[item] = std::exchange(leaf_of_[old], none), at = place_in(leaves_[node], old);
    leaves_[node].item[at] = item;
    if (at == 0) first_changed(node);
  }

  // What would be the neighbours of an item for which is_above(key) tells as it does for insert.
  template <class IsAbove>
  Neighbours around(IsAbove&& is_above) const {
    if (height_ == 0) return {};
    const Place place = find(is_above);
    const Leaf& leaf = leaves_[place.leaf];
    Neighbours around;
    if (place.at < leaf.count) {
      around.above = leaf.item[place.at];
      around.below = neighbours(leaf, place.at).below;
    } else {  // a leaf of the list is not empty
      around.below = leaf.item[place.at - 1];
      around.above = neighbours(leaf, place.at - 1).above;
    }
    return around;
  }

  // Removes an item of the list. Returns what its neighbours were.
  Neighbours erase(std::uint32_t item) {
    const std::uint32_t node = std::exchange(leaf_of_[item], none);
    Leaf& leaf = leaves_[node];
    const std::uint32_t at = place_in(leaf, item);
    const Neighbours around = neighbours(leaf, at);
    std::copy(leaf.item.begin() + at + 1, leaf.item.begin() + leaf.count, leaf.item.begin() + at);
    if (--leaf.count == 0) {
      drop(node);
    } else if (at == 0) {
      first_changed(node);
    }
    return around;
  }

  // The first and the last item of a list that is not empty.
  std::uint32_t lowest() const {
    std::uint32_t node = root_;
    for (int level = height_; level > 1; --level) node = inners_[node].child[0];
    return leaves_[node].item[0];
  }
  std::uint32_t highest() const {
    std::uint32_t node = root_;
    for (int level = height_; level > 1; --level) node = inners_[node].child[inners_[node].count - 1];
    return leaves_[node].item[leaves_[node].count - 1];
  }

  Neighbours neighbours_of(std::uint32_t item) const {
    const Leaf& leaf = leaves_[leaf_of_[item]];
    return neighbours(leaf, place_in(leaf, item));
  }

  // The row of those around an item of the list of which holds(other) is true, which stand together with it, from below
  // to above, and what stands next to it. Asks from near to far, first those below.
  template <class Holds>
  Neighbours row_around(std::uint32_t item, const Holds& holds, std::vector<std::uint32_t>& row) const {
    row.clear();
    const auto take = [&](std::uint32_t other) {
      if (!holds(other)) return false;
      row.push_back(other);
      return true;
    };
    Neighbours around;
    around.below = walk_down(item, take);
    std::reverse(row.begin(), row.end());
    row.push_back(item);
    around.above = walk_up(item, take);
    return around;
  }

  // Asks take(other) of what stands below an item of the list, or above it, from near to far, until that is false.
  // Returns the item for which it was, or none.
  template <class Take>
  std::uint32_t walk_down(std::uint32_t item, const Take& take) const {
    std::uint32_t node = leaf_of_[item], at = place_in(leaves_[node], item);
    for (;;) {
      for (; at > 0; --at) {
        if (const std::uint32_t other = leaves_[node].item[at - 1]; !take(other)) return other;
      }
      node = leaves_[node].before;
      if (node == none) return none;
      at = leaves_[node].count;
    }
  }
  template <class Take>
  std::uint32_t walk_up(std::uint32_t item, const Take& take) const {
    std::uint32_t node = leaf_of_[item], at = place_in(leaves_[node], item) + 1;
    for (;;) {
      for (; at < leaves_[node].count; ++at) {
        if (const std::uint32_t other = leaves_[node].item[at]; !take(other)) return other;
      }
      node = leaves_[node].after;
      if (node == none) return none;
      at = 0;
    }
  }

  // Two items of the list change places.
  void exchange(std::uint32_t lower, std::uint32_t upper) {
    const std::uint32_t node = leaf_of_[lower], next = leaf_of_[upper];
    const std::uint32_t at = place_in(leaves_[node], lower), then = place_in(leaves_[next], upper);
    leaves_[node].item[at] = upper;
    leaves_[next].item[then] = lower;
    std::swap(leaf_of_[lower], leaf_of_[upper]);
    if (at == 0) first_changed(node);
    if (then == 0) first_changed(next);
  }

 private:
  static constexpr std::uint32_t most_items = 60, most_children = 60;
  struct Leaf {  // four cache lines
    std::uint32_t count = 0, parent = none, before = none, after = none;
    std::array<std::uint32_t, most_items> item;
  };
  struct Inner {
    std::uint32_t count = 0, parent = none;
    std::array<std::uint32_t, most_children> child;
    std::array<Key, most_children> key;  // of the first item below child[k]; key[0] is not kept
  };

  struct Place {
    std::uint32_t leaf, at;
  };

  template <class IsAbove>
  Place find(IsAbove&& is_above) const {
    std::uint32_t node = root_;
    bool first_is_below = false;  // is the first item of the node known to be below?
    for (int level = height_; level > 1; --level) {
      const Inner& inner = inners_[node];
      std::uint32_t low = 0, high = inner.count;
      while (high - low > 1) {
        const std::uint32_t middle = low + (high - low) / 2;
        (is_above(inner.key[middle]) ? low : high) = middle;
      }
      first_is_below = first_is_below || low > 0;
      node = inner.child[low];
    }
    const Leaf& leaf = leaves_[node];
    std::uint32_t first = first_is_below ? 1 : 0, last = leaf.count;
    while (first < last) {
      const std::uint32_t middle = first + (last - first) / 2;
      if (is_above(keys_[leaf.item[middle]])) {
        first = middle + 1;
      } else {
        last = middle;
      }
    }
    return {node, first};
  }

  template <class Node>
  static std::uint32_t make(std::vector<Node>& nodes, std::vector<std::uint32_t>& free) {
    if (free.empty()) {
      nodes.emplace_back();
      return static_cast<std::uint32_t>(nodes.size() - 1);
    }
    const std::uint32_t node = free.back();
    free.pop_back();
    nodes[node].count = 0;
    nodes[node].parent = none;
    return node;
  }
  std::uint32_t make_leaf() {
    const std::uint32_t leaf = make(leaves_, free_leaves_);
    leaves_[leaf].before = leaves_[leaf].after = none;
    return leaf;
  }

  void start() {
    root_ = make_leaf();
    height_ = 1;
  }

  static std::uint32_t place_in(const Leaf& leaf, std::uint32_t item) {
    return static_cast<std::uint32_t>(std::find(leaf.item.begin(), leaf.item.begin() + leaf.count, item) -
                                      leaf.item.begin());
  }
  static std::uint32_t place_in(const Inner& inner, std::uint32_t child) {
    return static_cast<std::uint32_t>(std::find(inner.child.begin(), inner.child.begin() + inner.count, child) -
                                      inner.child.begin());
  }

  Neighbours put(std::uint32_t node, std::uint32_t at, std::uint32_t item) {
    if (leaves_[node].count == most_items) {
      const std::uint32_t upper = split_leaf(node), lower_count = leaves_[node].count;
      if (at > lower_count) {
        at -= lower_count;
        node = upper;
      }
    }
    Leaf& leaf = leaves_[node];
    std::copy_backward(leaf.item.begin() + at, leaf.item.begin() + leaf.count, leaf.item.begin() + leaf.count + 1);
    leaf.item[at] = item;
    ++leaf.count;
    leaf_of_[item] = node;
    return neighbours(leaf, at);  // at the front of a leaf an item is put in the first leaf only: no key changes
  }

  // Moves the upper half of a leaf to a new one after it.
  std::uint32_t split_leaf(std::uint32_t lower) {
    const std::uint32_t upper = make_leaf();
    Leaf &low = leaves_[lower], &high = leaves_[upper];
    const std::uint32_t half = low.count / 2;
    std::copy(low.item.begin() + half, low.item.begin() + low.count, high.item.begin());
    high.count = low.count - half;
    low.count = half;
    for (std::uint32_t k = 0; k < high.count; ++k) leaf_of_[high.item[k]] = upper;
    high.before = lower;
    high.after = low.after;
    if (low.after != none) leaves_[low.after].before = upper;
    low.after = upper;
    high.parent = add_after(low.parent, lower, upper, keys_[high.item[0]], 1);
    return upper;
  }

  // Enters `upper`, a node at `level`, into the parent, just after its child `lower`. Returns the parent of `upper`.
  std::uint32_t add_after(std::uint32_t parent, std::uint32_t lower, std::uint32_t upper, const Key& key, int level) {
    if (parent == none) {
      parent = make(inners_, free_inners_);
      inners_[parent].count = 1;
      inners_[parent].child[0] = lower;
      set_parent(lower, level, parent);
      root_ = parent;
      ++height_;
    }
    std::uint32_t at = place_in(inners_[parent], lower) + 1;
    if (inners_[parent].count == most_children) {
      const std::uint32_t other = split_inner(parent, level), lower_count = inners_[parent].count;
      if (at > lower_count) {
        at -= lower_count;
        parent = other;
      }
    }
    Inner& inner = inners_[parent];
    std::copy_backward(inner.child.begin() + at, inner.child.begin() + inner.count,
                       inner.child.begin() + inner.count + 1);
    std::copy_backward(inner.key.begin() + at, inner.key.begin() + inner.count, inner.key.begin() + inner.count + 1);
    inner.child[at] = upper;
    inner.key[at] = key;
    ++inner.count;
    return parent;
  }

  // Moves the upper half of an inner node, whose children are at `level`, to a new one after it.
  std::uint32_t split_inner(std::uint32_t lower, int level) {
    const std::uint32_t upper = make(inners_, free_inners_);
    Inner &low = inners_[lower], &high = inners_[upper];
    const std::uint32_t half = low.count / 2;
    std::copy(low.child.begin() + half, low.child.begin() + low.count, high.child.begin());
    std::copy(low.key.begin() + half, low.key.begin() + low.count, high.key.begin());
    high.count = low.count - half;
    low.count = half;
    for (std::uint32_t k = 0; k < high.count; ++k) set_parent(high.child[k], level, upper);
    const Key key = high.key[0];
    const std::uint32_t above = add_after(low.parent, lower, upper, key, level + 1);  // may move the nodes
    inners_[upper].parent = above;
    return upper;
  }

  void set_parent(std::uint32_t node, int level, std::uint32_t parent) {
    (level == 1 ? leaves_[node].parent : inners_[node].parent) = parent;
  }

  // The first item of this leaf, which is not empty, is another one now.
  void first_changed(std::uint32_t leaf) { first_changed_below(leaves_[leaf].parent, leaf, leaf); }
  void first_changed_below(std::uint32_t parent, std::uint32_t child, std::uint32_t leaf) {
    while (parent != none) {
      Inner& inner = inners_[parent];
      const std::uint32_t at = place_in(inner, child);
      if (at > 0) {
        inner.key[at] = keys_[leaves_[leaf].item[0]];
        return;
      }
      child = std::exchange(parent, inner.parent);
    }
  }

  // Takes an empty leaf out, and what gets empty above it.
  void drop(std::uint32_t node) {
    const std::uint32_t before = leaves_[node].before, after = leaves_[node].after;
    if (before != none) leaves_[before].after = after;
    if (after != none) leaves_[after].before = before;
    std::uint32_t parent = leaves_[node].parent;
    free_leaves_.push_back(node);
    while (parent != none && inners_[parent].count == 1) {
      node = parent;
      parent = inners_[node].parent;
      free_inners_.push_back(node);
    }
    if (parent == none) {
      height_ = 0;
      return;
    }
    Inner& inner = inners_[parent];
    const std::uint32_t at = place_in(inner, node);
    std::copy(inner.child.begin() + at + 1, inner.child.begin() + inner.count, inner.child.begin() + at);
    std::copy(inner.key.begin() + at + 1, inner.key.begin() + inner.count, inner.key.begin() + at);
    --inner.count;
    if (at == 0) first_changed_below(inner.parent, parent, after);  // the leaf after is now the first below this node
  }

  Neighbours neighbours(const Leaf& leaf, std::uint32_t at) const {
    Neighbours around;
    if (at > 0) {
      around.below = leaf.item[at - 1];
    } else if (leaf.before != none) {
      around.below = leaves_[leaf.before].item[leaves_[leaf.before].count - 1];
    }
    if (at + 1 < leaf.count) {
      around.above = leaf.item[at + 1];
    } else if (leaf.after != none) {
      around.above = leaves_[leaf.after].item[0];
    }
    return around;
  }

  std::span<const Key> keys_;
  std::vector<Leaf> leaves_;
  std::vector<Inner> inners_;
  std::vector<std::uint32_t> free_leaves_, free_inners_;
  std::vector<std::uint32_t> leaf_of_;  // of each item; none: not in the list
  std::uint32_t root_ = none;           // an inner node where height_ > 1, else a leaf
  int height_ = 0;                      // 0: the list is empty
};

}  // namespace sunder::planar
