// The segments that a sweep line cuts, from below to above: an ordered list in blocks.
//
// A directory of blocks is searched first, then one block: about log2 of the length comparisons. A block is a few cache
// lines; the directory moves only when a block is split or empty. Whoever inserts knows the order: the list never
// compares by itself.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace sunder::planar {

class SweepStatus {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Neighbours {
    std::uint32_t below = none, above = none;
  };

  // For items 0 .. count - 1.
  explicit SweepStatus(std::uint32_t count) : block_of_(count, none) {}

  // Inserts an item that is not in the list, between those of which `is_above(other)`, "the new one is above the
  // other", is true and the rest. Requires that these stand first. Returns its neighbours.
  template <class IsAbove>
  Neighbours insert(std::uint32_t item, IsAbove&& is_above) {
    if (directory_.empty()) {
      directory_.push_back(new_block());
      Block& only = blocks_[directory_[0]];
      only.item[only.count++] = item;
      block_of_[item] = directory_[0];
      return {};
    }
    // The last block whose first item is below the new one, or the first block.
    std::size_t low = 0, high = directory_.size();
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (is_above(blocks_[directory_[middle]].item[0]) ? low : high) = middle;
    }
    const Block& found = blocks_[directory_[low]];
    std::uint32_t first = low > 0 ? 1 : 0, last = found.count;  // of a later block, the first item is known to be below
    while (first < last) {
      const std::uint32_t middle = first + (last - first) / 2;
      if (is_above(found.item[middle])) {
        first = middle + 1;
      } else {
        last = middle;
      }
    }
    return put(low, first, item);
  }

  // Removes an item of the list. Returns what its neighbours were.
  Neighbours erase(std::uint32_t item) {
    const std::uint32_t b = block_of_[item];
    Block& block = blocks_[b];
    const std::uint32_t at = static_cast<std::uint32_t>(
        std::find(block.item.begin(), block.item.begin() + block.count, item) - block.item.begin());
    const Neighbours around = neighbours(block, at);
    std::copy(block.item.begin() + at + 1, block.item.begin() + block.count, block.item.begin() + at);
    block_of_[item] = none;
    if (--block.count == 0) drop(b);
    return around;
  }

 private:
  static constexpr std::uint32_t most = 61;  // items in a block, which then has 256 bytes
  struct Block {
    std::uint32_t count = 0, before = none, after = none;
    std::array<std::uint32_t, most> item;
  };

  std::uint32_t new_block() {
    if (free_.empty()) {
      blocks_.emplace_back();
      return static_cast<std::uint32_t>(blocks_.size() - 1);
    }
    const std::uint32_t b = free_.back();
    free_.pop_back();
    blocks_[b].count = 0;
    blocks_[b].before = blocks_[b].after = none;
    return b;
  }

  // Puts the item at a position of the block at a place of the directory.
  Neighbours put(std::size_t place, std::uint32_t at, std::uint32_t item) {
    if (blocks_[directory_[place]].count == most) {
      split(place);
      const std::uint32_t lower = blocks_[directory_[place]].count;
      if (at > lower) {
        at -= lower;
        ++place;
      }
    }
    Block& block = blocks_[directory_[place]];
    std::copy_backward(block.item.begin() + at, block.item.begin() + block.count, block.item.begin() + block.count + 1);
    block.item[at] = item;
    ++block.count;
    block_of_[item] = directory_[place];
    return neighbours(block, at);
  }

  // Moves the upper half of a block to a new one after it.
  void split(std::size_t place) {
    const std::uint32_t lower = directory_[place], upper = new_block();
    Block &low = blocks_[lower], &high = blocks_[upper];
    const std::uint32_t half = low.count / 2;
    std::copy(low.item.begin() + half, low.item.begin() + low.count, high.item.begin());
    high.count = low.count - half;
    low.count = half;
    for (std::uint32_t k = 0; k < high.count; ++k) block_of_[high.item[k]] = upper;
    high.before = lower;
    high.after = low.after;
    if (low.after != none) blocks_[low.after].before = upper;
    low.after = upper;
    directory_.insert(directory_.begin() + static_cast<std::ptrdiff_t>(place) + 1, upper);
  }

  void drop(std::uint32_t b) {
    const Block& block = blocks_[b];
    if (block.before != none) blocks_[block.before].after = block.after;
    if (block.after != none) blocks_[block.after].before = block.before;
    directory_.erase(std::find(directory_.begin(), directory_.end(), b));
    free_.push_back(b);
  }

  Neighbours neighbours(const Block& block, std::uint32_t at) const {
    Neighbours around;
    if (at > 0) {
      around.below = block.item[at - 1];
    } else if (block.before != none) {
      around.below = blocks_[block.before].item[blocks_[block.before].count - 1];
    }
    if (at + 1 < block.count) {
      around.above = block.item[at + 1];
    } else if (block.after != none) {
      around.above = blocks_[block.after].item[0];
    }
    return around;
  }

  std::vector<Block> blocks_;
  std::vector<std::uint32_t> directory_;  // blocks from below to above
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> block_of_;
};

}  // namespace sunder::planar
