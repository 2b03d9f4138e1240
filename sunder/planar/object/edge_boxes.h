// Boxes of runs of edges of a polygon, and of runs of those: which edges may be near something?
// Also called: bounding volume hierarchy (BVH), tree of axis-aligned boxes (AABB tree); packed R-tree.
//
// A run is a few edges that are numbered in turn; on the next level it is a few runs, and so on, until few are left.
// Boxes of runs have their sides moved outwards to floats: what meets a true box meets its coarse one. Four of them,
// which make a run of the next level, are as large as a cache line and are compared at once.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/near/lanes_box.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

struct CoarseBox {
  float left, right, bottom, top;

  LanesBox in_doubles() const {
    const auto wide = [](float x) { return static_cast<double>(x); };
    return {Lanes{wide(left), wide(bottom)}, Lanes{wide(right), wide(top)}};
  }
};

CoarseBox coarse(const LanesBox& box);

inline CoarseBox hull(const CoarseBox& a, const CoarseBox& b) {
  return {std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.bottom, b.bottom), std::max(a.top, b.top)};
}

inline CoarseBox common_part(const CoarseBox& a, const CoarseBox& b) {
  return {std::max(a.left, b.left), std::min(a.right, b.right), std::max(a.bottom, b.bottom), std::min(a.top, b.top)};
}

struct FourBoxes {
  FloatLanes left, right, bottom, top;

  static FourBoxes all(const CoarseBox& b) {
    const auto four = [](float x) { return FloatLanes{x, x, x, x}; };
    return {four(b.left), four(b.right), four(b.bottom), four(b.top)};
  }
  CoarseBox operator[](std::uint32_t k) const { return {left[k], right[k], bottom[k], top[k]}; }
  void put(std::uint32_t k, const CoarseBox& b) {
    left[k] = b.left;
    right[k] = b.right;
    bottom[k] = b.bottom;
    top[k] = b.top;
  }
};

// A bit for each pair of boxes at the same place that meet.
inline std::uint32_t meeting(const FourBoxes& a, const FourBoxes& b) {
  return bits_of_four((a.left <= b.right) & (b.left <= a.right) & (a.bottom <= b.top) & (b.bottom <= a.top));
}

class EdgeBoxes {
 public:
  static constexpr std::uint32_t fan = 4;    // edges, or runs, in a run: those from fan k on are in run k
  static constexpr std::uint32_t most = 16;  // runs of the top level

  EdgeBoxes() = default;
  // Of the boxes of the edges, in turn. Cost: linear.
  explicit EdgeBoxes(std::span<const LanesBox> edges);

  const CoarseBox& whole() const { return whole_; }  // of all edges
  std::uint32_t top() const { return top_; }         // the level; the lowest one, of runs of edges, is 0

  // Four k has the runs from fan k on; where a level has fewer, boxes follow that meet none.
  std::span<const FourBoxes> level(std::uint32_t l) const {
    std::uint32_t begin = 0, size = fours_;
    for (; l > 0; --l) {
      begin += size;
      size = fours_of(size);
    }
    return {boxes_.data() + begin, size};
  }
  CoarseBox box(std::uint32_t l, std::uint32_t run) const { return level(l)[run / fan][run % fan]; }

 private:
  static std::uint32_t fours_of(std::uint32_t members) { return (members + fan - 1) / fan; }

  std::uint32_t fours_ = 0, top_ = 0;  // fours_: of the lowest level
  CoarseBox whole_{};
  std::vector<FourBoxes> boxes_;  // level after level
};

}  // namespace sunder::planar
