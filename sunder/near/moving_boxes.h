// Which of many boxes that move meet? A broad phase that follows them, and costs what has changed.
// Also called: dynamic bounding volume hierarchy, dynamic AABB tree; temporal coherence; broad phase.
//
// Each box is kept wider by a margin, some eight of its own last moves, and a quarter of its greatest side at most: so
// what moves slowly changes nothing for several moves, and what rests is not widened. The wide boxes are the leaves of
// a balanced tree (box_tree.h).
//   B1. Every wanted pair of boxes that have a common point is among pairs(), exactly: ends of boxes are compared as
//       they are, and a margin, whatever is rounded in it, only ever widens. Ends may be infinite, not NaN.
//   B2. pairs() is the same for every compiler and machine, given the same moves.
// Memory: at most 200 bytes a box and 32 a pair, for 1,000 and more (tested).
// What one might assume and does not hold: pairs() also has pairs that are merely near, by their margins.
#pragma once

#include <sunder/near/box_tree.h>
#include <sunder/predicate/point.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace sunder {

class MovingBoxes {
 public:
  using Wanted = std::function<bool(std::uint32_t, std::uint32_t)>;

  struct Pair {
    std::uint32_t i, j;  // i < j
    std::uint32_t slot;  // its own as long as it is there, to keep something about it in; less than slot_count()
  };

  // wanted(i, j), i < j: is this pair asked about? Always the same answer. Requires fewer than 2^31 boxes.
  // Cost: O(n log n) and the pairs.
  MovingBoxes(std::span<const Box3> boxes, Wanted wanted);

  // The box is here now; update() makes it count. Requires i < size().
  void move(std::uint32_t i, const Box3& box);

  // The pairs after all moves. Cost: for each box that left its wide one O(log n + k), where its box meets k others;
  // and a look at every pair, if there is such a box. The tree is made again, in O(n log n), when searches in it have
  // cost as much.
  void update();

  std::size_t size() const { return boxes_.size(); }
  const Box3& box(std::uint32_t i) const { return boxes_[i]; }
  std::span<const Pair> pairs() const { return pairs_; }           // in no particular order
  std::span<const std::uint32_t> fresh() const { return fresh_; }  // slots of the pairs that are new with update()
  std::size_t slot_count() const { return slots_; }
  std::uint64_t looks() const { return looks_; }  // at boxes of nodes and leaves, since the beginning

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  Box3 widened(const Box3& box, const Box3& before) const;
  void drop_parted();
  void search(std::size_t change);
  void consider(std::uint32_t i, std::uint32_t j, const Box3& before);
  const Box3& wide(std::uint32_t i) const { return tree_.box(i); }

  Wanted wanted_;
  std::vector<Box3> boxes_;             // as given last
  BoxTree tree_;                        // of the wide ones
  std::vector<std::uint32_t> changed_;  // boxes that left their wide ones since the last update
  std::vector<Box3> before_;            // of each of these the wide box that it left
  std::vector<std::uint32_t> change_;   // of each box its place in changed_, or none
  std::vector<Pair> pairs_;
  std::vector<std::uint32_t> fresh_, free_;  // slots
  std::size_t slots_ = 0;
  std::uint64_t looks_ = 0, wasted_ = 0;
  bool is_new_ = true;  // no pair has been looked for
};

}  // namespace sunder
