// Which of many boxes meet, of any dimension? The broad phase of a scene.
// Also called: sweep and prune; sort and sweep; broad phase.
#pragma once

#include <sunder/predicate/point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace sunder {

// The axis on which the lower ends are spread most.
template <class BoxLike>
std::size_t widest_axis(std::span<const BoxLike> boxes) {
  std::size_t widest = 0;
  double most = -1;
  for (std::size_t k = 0; k < dimension_of<BoxLike>; ++k) {
    double least = std::numeric_limits<double>::max(), greatest = std::numeric_limits<double>::lowest();
    for (const BoxLike& box : boxes) {
      if (!std::isfinite(box.low[k])) continue;
      least = std::min(least, box.low[k]);
      greatest = std::max(greatest, box.low[k]);
    }
    const double spread = greatest / 2 - least / 2;  // halves do not overflow
    if (spread > most) {
      most = spread;
      widest = k;
    }
  }
  return widest;
}

// All pairs {i, j}, i < j, of boxes that have a common point, in increasing order. Ends may be infinite, not NaN.
// Sorts the boxes along the widest axis, and sweeps over it: any axis is right, a good one is fast.
// BoxLike: a Box<D>, or what derives from one.
// Cost: n log n, one comparison for each pair that meets along that axis, and the sorting of the result.
template <class BoxLike>
std::vector<std::array<std::uint32_t, 2>> meeting_boxes(std::span<const BoxLike> boxes) {
  const std::size_t k = widest_axis(boxes);
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return boxes[i].low[k] != boxes[j].low[k] ? boxes[i].low[k] < boxes[j].low[k] : i < j;
  });

  std::vector<std::array<std::uint32_t, 2>> pairs;
  std::vector<std::uint32_t> open;  // boxes that the sweep has entered and perhaps not left
  for (const std::uint32_t i : order) {
    std::erase_if(open, [&](std::uint32_t j) { return boxes[j].high[k] < boxes[i].low[k]; });
    for (const std::uint32_t j : open) {
      if (meet(boxes[i], boxes[j])) pairs.push_back({std::min(i, j), std::max(i, j)});
    }
    open.push_back(i);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace sunder
