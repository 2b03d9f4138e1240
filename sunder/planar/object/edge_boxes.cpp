#include <sunder/planar/object/edge_boxes.h>

#include <cmath>
#include <limits>

namespace sunder::planar {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// The greatest float that is not greater: for doubles beyond all floats, the last one or minus infinity.
float rounded_down(double x) {
  const float f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, -infinite) : f;
}

float rounded_up(double x) { return -rounded_down(-x); }

}  // namespace

CoarseBox coarse(const LanesBox& box) {
  return {rounded_down(box.low[0]), rounded_up(box.high[0]), rounded_down(box.low[1]), rounded_up(box.high[1])};
}

EdgeBoxes::EdgeBoxes(std::span<const LanesBox> edges) {
  constexpr float nothing = std::numeric_limits<float>::quiet_NaN();  // compares as false: such a box meets none
  std::vector<CoarseBox> runs;
  for (std::size_t k = 0; k < edges.size(); k += fan) {
    LanesBox run = edges[k];
    for (std::size_t l = k + 1; l < std::min(k + fan, edges.size()); ++l) run = hull(run, edges[l]);
    runs.push_back(coarse(run));
  }
  fours_ = fours_of(static_cast<std::uint32_t>(runs.size()));
  for (;; ++top_) {
    std::vector<CoarseBox> next;
    for (std::size_t k = 0; k < runs.size(); k += fan) {
      FourBoxes four = FourBoxes::all({nothing, nothing, nothing, nothing});
      CoarseBox all = runs[k];
      for (std::uint32_t l = 0; l < fan && k + l < runs.size(); ++l) {
        four.put(l, runs[k + l]);
        all = hull(all, runs[k + l]);
      }
      boxes_.push_back(four);
      next.push_back(all);
    }
    if (runs.size() <= most) {
      whole_ = next[0];
      for (const CoarseBox& run : next) whole_ = hull(whole_, run);
      break;
    }
    runs.swap(next);
  }
  boxes_.shrink_to_fit();
}

}  // namespace sunder::planar
