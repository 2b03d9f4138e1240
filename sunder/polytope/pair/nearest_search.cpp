#include <sunder/polytope/pair/nearest_search.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder::polytope {

bool NearestSimplex::has(std::uint32_t a, std::uint32_t b) const {
  return std::any_of(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(size_),
                     [&](const DifferencePoint& p) { return p.a == a && p.b == b; });
}

bool towards_origin(const ColumnNumbers& from, std::size_t d, ColumnNumbers& direction) {
  double largest = 0;
  for (std::size_t c = 0; c < d; ++c) largest = std::max(largest, std::fabs(from[c]));
  if (!(largest > 0) || !std::isfinite(largest)) return false;
  for (std::size_t c = 0; c < d; ++c) {
    const double part = -from[c] / largest;
    direction[c] = std::fabs(part) < 0x1p-60 ? 0.0 : part;
  }
  return true;
}

bool NearestSimplex::is_at_origin(double size) const {
  double rest = 0;
  for (std::size_t c = 0; c < d_; ++c) {
    rest = std::max(rest, std::fabs(nearest_[c]));
    for (std::size_t k = 0; k < size_; ++k) size = std::max(size, std::fabs(points_[k].at[c]));
  }
  return size_ > 0 && rest <= size * 0x1p-49;
}

// With p_0 the first point and e_k = p_k - p_0: the least |p_0 + sum y_k e_k|^2, by the orthogonal parts of the edges
// (Gram and Schmidt, each edge after those before it), which is stable enough to propose. Edges that were there the
// last time, with all before them, keep theirs.
bool NearestSimplex::affine_weights(std::array<double, most_columns + 1>& weights) {
  const std::size_t n = size_ - 1;
  for (; known_edges_ < n; ++known_edges_) {
    const std::size_t j = known_edges_;
    OrthogonalEdge& edge = edges_[j];
    ColumnNumbers& o = edge.part;
    edge.share = {};
    edge.rest = j == 0 ? points_[0].at : edges_[j - 1].rest;
    double whole = 0, square = 0;
    for (std::size_t c = 0; c < d_; ++c) {
      o[c] = points_[j + 1].at[c] - points_[0].at[c];
      whole += o[c] * o[c];
    }
    for (int pass = 0; pass < 2; ++pass) {  // twice is enough
      for (std::size_t k = 0; k < j; ++k) {
        double product = 0;
        for (std::size_t c = 0; c < d_; ++c) product += o[c] * edges_[k].part[c];
        const double part = product * edges_[k].inverse_square;
        edge.share[k] += part;
        for (std::size_t c = 0; c < d_; ++c) o[c] -= part * edges_[k].part[c];
      }
    }
    double product = 0;
    for (std::size_t c = 0; c < d_; ++c) {
      square += o[c] * o[c];
      product += edge.rest[c] * o[c];
    }
    if (!(square > whole * 0x1p-90)) return false;
    edge.inverse_square = 1 / square;
    edge.along = -product * edge.inverse_square;
    for (std::size_t c = 0; c < d_; ++c) edge.rest[c] += edge.along * o[c];
  }
  // p_0 + sum along_j o_j, in terms of edges: o_j = e_j - sum share_jk o_k, from the last one back.
  std::array<double, most_columns> along{};
  for (std::size_t j = 0; j < n; ++j) along[j] = edges_[j].along;
  weights[0] = 1;
  for (std::size_t j = n; j-- > 0;) {
    for (std::size_t k = 0; k < j; ++k) along[k] -= along[j] * edges_[j].share[k];
    weights[j + 1] = along[j];
    weights[0] -= along[j];
  }
  return std::all_of(weights.begin(), weights.begin() + static_cast<std::ptrdiff_t>(size_),
                     [](double w) { return std::isfinite(w); });
}

void NearestSimplex::drop_without_weight() {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    if (!(weights_[k] > 0)) {
      known_edges_ = std::min(known_edges_, kept == 0 ? 0 : kept - 1);
      continue;
    }
    if (kept != k) points_[kept] = points_[k];
    weights_[kept++] = weights_[k];
  }
  size_ = kept;
}

void NearestSimplex::find_nearest() {
  nearest_ = {};
  for (std::size_t k = 0; k < size_; ++k) {
    for (std::size_t c = 0; c < d_; ++c) nearest_[c] += weights_[k] * points_[k].at[c];
  }
}

bool NearestSimplex::add(const DifferencePoint& point) {
  points_[size_] = point;
  weights_[size_] = size_ == 0 ? 1 : 0;
  ++size_;
  for (std::size_t round = 0; round <= most_columns + 1; ++round) {
    std::array<double, most_columns + 1> target{};
    if (!affine_weights(target)) return false;
    // From the weights towards the target, as far as none is negative.
    double step = 1;
    std::size_t first = size_;
    for (std::size_t k = 0; k < size_; ++k) {
      if (target[k] > 0) continue;
      const double room = weights_[k] / (weights_[k] - target[k]);
      if (room < step || first == size_) {
        step = std::min(room, 1.0);
        first = k;
      }
    }
    if (first == size_) {
      weights_ = target;
      find_nearest();
      return true;
    }
    if (!(step >= 0)) step = 0;
    for (std::size_t k = 0; k < size_; ++k) weights_[k] += step * (target[k] - weights_[k]);
    weights_[first] = 0;
    drop_without_weight();
    if (size_ == 0) return false;
  }
  return false;
}

}  // namespace sunder::polytope
