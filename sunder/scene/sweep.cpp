#include <sunder/scene/sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sunder::scene {

namespace {

// The axis on which the lower ends are spread most: any axis is right, a good one is fast.
std::size_t widest_axis(std::span<const WorldBox> boxes) {
  std::size_t widest = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    double least = std::numeric_limits<double>::max(), greatest = std::numeric_limits<double>::lowest();
    for (const WorldBox& box : boxes) {
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

}  // namespace

std::vector<std::array<std::uint32_t, 2>> meeting_boxes(std::span<const WorldBox> boxes) {
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

}  // namespace sunder::scene
