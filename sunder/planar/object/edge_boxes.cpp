#include <sunder/planar/object/edge_boxes.h>

namespace sunder::planar {

EdgeBoxes::EdgeBoxes(std::span<const Segment> edges) : size_(runs_of(static_cast<std::uint32_t>(edges.size()))) {
  std::size_t all = size_;
  for (std::uint32_t size = size_; size > most; ++top_) all += size = runs_of(size);
  boxes_.reserve(all);
  const auto add_runs = [this](std::size_t begin, std::size_t end, const auto& box_of) {
    for (std::size_t k = begin; k < end; k += fan) {
      LanesBox run = box_of(k);
      for (std::size_t l = k + 1; l < std::min(k + fan, end); ++l) run = hull(run, box_of(l));
      boxes_.push_back(run);
    }
  };
  add_runs(0, edges.size(), [&](std::size_t k) { return box_of_edge(edges[k].a, edges[k].b); });
  for (std::size_t begin = 0; boxes_.size() < all;) {
    const std::size_t end = boxes_.size();
    add_runs(begin, end, [&](std::size_t k) { return boxes_[k]; });
    begin = end;
  }
}

}  // namespace sunder::planar
