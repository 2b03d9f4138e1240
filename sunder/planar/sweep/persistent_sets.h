// Sets of numbers of which one differs from another in a member, and shares the rest with it.
// Also called: Patricia trie; mergeable integer maps.
//
// A set is a binary tree over the bits of its members, without nodes that have one child; it is never changed. To take
// a member in or out copies the way to it. A node is freed when the last set that holds it is released.
// Cost: to take a member in or out, or to look for one, at most one step for each bit of the greatest number, and for
// each two members. Memory: as many nodes.
// Source: Okasaki & Gill 1998, Fast mergeable integer maps.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder::planar {

class PersistentSets {
 public:
  using Set = std::uint32_t;
  static constexpr Set empty = 0xffffffffu;

  // With the member, or without it where it is one already. This, and again(), give a set that is to be released once.
  Set toggled(Set set, std::uint32_t member) {
    if (set == empty) return single(member);
    ++steps;
    const Node node = nodes_[set];
    if (node.bit == 0) return node.key == member ? empty : joined(set, node.key, member);
    if (bits_above(member, node.bit) != node.key) return joined(set, node.key, member);
    const bool in_low = (member & node.bit) == 0;
    const Set changed = toggled(in_low ? node.low : node.high, member), kept = again(in_low ? node.high : node.low);
    if (changed == empty) return kept;
    return make(node.key, node.bit, in_low ? changed : kept, in_low ? kept : changed);
  }

  Set again(Set set) {
    if (set != empty) ++nodes_[set].uses;
    return set;
  }

  void release(Set set) {
    if (set == empty || --nodes_[set].uses > 0) return;
    ++steps;
    const Node node = nodes_[set];
    free_.push_back(set);
    if (node.bit == 0) return;
    release(node.low);
    release(node.high);
  }

  bool holds(Set set, std::uint32_t member) {
    while (set != empty) {
      ++steps;
      const Node& node = nodes_[set];
      if (node.bit == 0) return node.key == member;
      set = (member & node.bit) == 0 ? node.low : node.high;
    }
    return false;
  }

  // In ascending order.
  template <class Visit>
  void for_each(Set set, const Visit& visit) {
    for_each_without(set, 1, 0, visit);
  }
  // Those from `first` to `last` are left out: passed as one.
  template <class Visit>
  void for_each_without(Set set, std::uint32_t first, std::uint32_t last, const Visit& visit) {
    if (set == empty) return;
    ++steps;
    const Node node = nodes_[set];
    const std::uint32_t greatest = node.bit == 0 ? node.key : node.key | node.bit | (node.bit - 1);
    if (first <= node.key && greatest <= last) return;
    if (node.bit == 0) return visit(node.key);
    for_each_without(node.low, first, last, visit);
    for_each_without(node.high, first, last, visit);
  }

  std::size_t size_in_nodes() const { return nodes_.size() - free_.size(); }

  std::uint64_t steps = 0;  // nodes made, freed and looked at

 private:
  struct Node {
    std::uint32_t key;  // the member; or the bits above `bit` that all below have in common
    std::uint32_t bit;  // in which those below differ: it is 0 in low, 1 in high; 0: a member
    Set low, high;
    std::uint32_t uses;
  };

  Set make(std::uint32_t key, std::uint32_t bit, Set low, Set high) {
    ++steps;
    const Node node{key, bit, low, high, 1};
    if (free_.empty()) {
      nodes_.push_back(node);
      return static_cast<Set>(nodes_.size() - 1);
    }
    const Set set = free_.back();
    free_.pop_back();
    nodes_[set] = node;
    return set;
  }
  Set single(std::uint32_t member) { return make(member, 0, empty, empty); }

  static std::uint32_t bits_above(std::uint32_t key, std::uint32_t bit) { return key & ~(bit | (bit - 1)); }

  // What holds the set and a member that differs from all of it above its bits.
  Set joined(Set set, std::uint32_t key, std::uint32_t member) {
    const std::uint32_t bit = std::bit_floor(key ^ member);
    const Set old = again(set), other = single(member);
    return (member & bit) == 0 ? make(bits_above(member, bit), bit, other, old)
                               : make(bits_above(member, bit), bit, old, other);
  }

  std::vector<Node> nodes_;
  std::vector<Set> free_;
};

}  // namespace sunder::planar
