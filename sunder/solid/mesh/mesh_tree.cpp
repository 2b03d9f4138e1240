#include <sunder/base/contract.h>
#include <sunder/solid/mesh/mesh_tree.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace sunder::solid {

namespace {

Box3 box_of_none() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

}  // namespace

MeshTree::MeshTree(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                   std::vector<std::uint32_t>& order)
    : size_(triangles.size()) {
  SUNDER_REQUIRE(triangles.size() < std::size_t{1} << 31);
  order.resize(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<Box3> boxes(triangles.size(), box_of_none());
  std::vector<Point3> middles(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::uint32_t corner : triangles[t]) boxes[t] = hull(boxes[t], {points[corner], points[corner]});
    for (std::size_t c = 0; c < 3; ++c) middles[t][c] = boxes[t].low[c] / 2 + boxes[t].high[c] / 2;
  }
  box_ = box_of_none();
  for (const Box3& box : boxes) box_ = hull(box_, box);
  double half = 0;
  for (std::size_t c = 0; c < 3 && !boxes.empty(); ++c) {
    middle_[c] = box_.low[c] / 2 + box_.high[c] / 2;
    half = std::max(half, box_.high[c] / 2 - box_.low[c] / 2);
  }
  unit_ = std::ldexp(1.0, half > 0x1p-1000 ? std::min(std::ilogb(half) + 1, 1023) : -1000);
  nodes_.resize(2 * std::bit_ceil(std::max<std::size_t>(1, (triangles.size() + leaf_size - 1) / leaf_size)));
  split(middles, order, 0, leaves());
  std::vector<Box3> of_nodes(nodes_.size(), box_of_none());
  for (std::size_t node = nodes_.size() - 1; node > 0; --node) {
    if (is_leaf(node)) {
      const auto [first, end] = this->triangles(node);
      std::sort(order.begin() + first, order.begin() + end);
      for (std::uint32_t k = first; k < end; ++k) of_nodes[node] = hull(of_nodes[node], boxes[order[k]]);
    } else {
      of_nodes[node] = hull(of_nodes[2 * node], of_nodes[2 * node + 1]);
    }
    if (of_nodes[node].low.x <= of_nodes[node].high.x) nodes_[node] = rounded(of_nodes[node]);
  }
}

// What is subtracted and halved is off by some parts in 2^53 of numbers up to unit_ and middle_, and by a part in 2^24 of
// the box's own middle, as that is rounded to single precision: all of this is added to the half.
SmallBox MeshTree::rounded(const Box3& box) const {
  SmallBox result;
  for (std::size_t c = 0; c < 3; ++c) {
    const double low = box.low[c] - middle_[c], high = box.high[c] - middle_[c];
    const double error = (std::fabs(low) + std::fabs(high)) * 0x1p-50 + unit_ * 0x1p-100;
    result.middle[c] = static_cast<float>((low / 2 + high / 2) / unit_);
    const double at = static_cast<double>(result.middle[c]) * unit_;
    const double half = std::max(high - at, at - low) + error;
    result.half[c] = std::nextafter(static_cast<float>(half / unit_), 4.0F);
  }
  return result;
}

void MeshTree::split(std::span<const Point3> middles, std::vector<std::uint32_t>& order, std::size_t first_leaf,
                     std::size_t leaves) {
  const auto at = [&](std::size_t leaf) { return order.begin() + static_cast<std::ptrdiff_t>(begin_of(leaf)); };
  if (leaves < 2) return;
  const auto begin = at(first_leaf), middle = at(first_leaf + leaves / 2), end = at(first_leaf + leaves);
  if (end - begin < 2) return;
  std::size_t axis = 0;
  double most = -1;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto less = [&](std::uint32_t s, std::uint32_t t) { return middles[s][c] < middles[t][c]; };
    const auto [least, greatest] = std::minmax_element(begin, end, less);
    const double spread = middles[*greatest][c] / 2 - middles[*least][c] / 2;  // halves do not overflow
    if (spread > most) most = spread, axis = c;
  }
  if (middle != end) {
    std::nth_element(begin, middle, end, [&](std::uint32_t s, std::uint32_t t) {
      return middles[s][axis] != middles[t][axis] ? middles[s][axis] < middles[t][axis] : s < t;
    });
  }
  split(middles, order, first_leaf, leaves / 2);
  split(middles, order, first_leaf + leaves / 2, leaves / 2);
}

}  // namespace sunder::solid
