// Boxes of runs of edges of a polygon, and of runs of those: which edges may be near something?
//
// A run is a few edges that are numbered in turn; on the next level it is a few runs, and so on, until few are left.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/planar/object/box.h>
#include <sunder/planar/object/segments.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// A box: its low and its high corner, of which both coordinates are compared at once.
struct LanesBox {
  Lanes low, high;
};

inline bool meet(const LanesBox& a, const LanesBox& b) {
  return (bits_of(a.low > b.high) | bits_of(a.high < b.low)) == 0;
}

inline LanesBox box_of_edge(const Point2& from, const Point2& to) {
  const Lanes a = lanes_at(&from.x), b = lanes_at(&to.x);
  return {smaller_of(a, b), greater_of(a, b)};
}

inline LanesBox hull(const LanesBox& a, const LanesBox& b) {
  return {smaller_of(a.low, b.low), greater_of(a.high, b.high)};
}

inline LanesBox common_part(const LanesBox& a, const LanesBox& b) {
  return {greater_of(a.low, b.low), smaller_of(a.high, b.high)};
}

class EdgeBoxes {
 public:
  static constexpr std::uint32_t fan = 4;    // edges, or runs, in a run: those from fan k on are in run k
  static constexpr std::uint32_t most = 16;  // runs of the top level

  EdgeBoxes() = default;
  // Cost: linear.
  explicit EdgeBoxes(std::span<const Segment> edges);

  std::uint32_t top() const { return top_; }  // the level; the lowest one, of runs of edges, is 0
  std::span<const LanesBox> level(std::uint32_t l) const {
    std::uint32_t begin = 0, size = size_;
    for (; l > 0; --l) {
      begin += size;
      size = runs_of(size);
    }
    return {boxes_.data() + begin, size};
  }

 private:
  static std::uint32_t runs_of(std::uint32_t members) { return (members + fan - 1) / fan; }

  std::uint32_t size_ = 0, top_ = 0;  // size_: of the lowest level
  std::vector<LanesBox> boxes_;       // level after level
};

}  // namespace sunder::planar
