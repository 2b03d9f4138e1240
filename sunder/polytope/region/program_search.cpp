#include <sunder/polytope/region/program_search.h>

#include <algorithm>
#include <cmath>

namespace sunder::polytope {

namespace {

// What counts as nothing: a proposal only.
constexpr double small = 0x1p-36;

class RoundedDualSimplex {
 public:
  RoundedDualSimplex(const Polytope& body, std::span<const double> objective) : body_(body), d_(body.dimension()) {
    double greatest = 0;
    for (const double x : objective) greatest = std::max(greatest, std::fabs(x));
    for (std::size_t j = 0; j < d_; ++j) {
      objective_[j] = greatest > 0 ? objective[j] / greatest : 0;
      signs_[j] = objective_[j] < 0 ? -1 : 1;
      basis_.rows[j] = first_box_side + static_cast<std::uint32_t>(j);
      inverse_[j][j] = signs_[j];
    }
  }

  RowBasis solve() {
    const std::size_t most_steps = 60 * d_;
    while (body_.size() > 0 && basis_.steps < most_steps) {
      const std::uint32_t entering = broken();
      if (entering >= first_box_side || !enter(entering)) break;
      ++basis_.steps;
    }
    return basis_;
  }

 private:
  using Numbers = std::array<double, most_dimension>;

  bool is_side(std::size_t i) const { return basis_.rows[i] >= first_box_side; }

  // The row that is broken most; else a side.
  std::uint32_t broken() {
    ColumnNumbers vertex{}, way{};
    double length = 0, size = 1;
    bool at_box = false;
    for (std::size_t i = 0; i < d_; ++i) {
      at_box = at_box || is_side(i);
      for (std::size_t j = 0; j < d_; ++j) (is_side(i) ? way : vertex)[j] += inverse_[j][i] * levels_[i];
    }
    if (at_box) {
      for (std::size_t j = 0; j < d_; ++j) {
        length = std::max(length, std::fabs(way[j]));
        size = std::max(size, std::fabs(vertex[j]));
      }
      const std::uint32_t along = furthest(way);
      if (along < first_box_side) return along;
      const double far = size * 0x1p+12 / length;
      for (std::size_t j = 0; j < d_; ++j) vertex[j] += far * way[j];
    }
    vertex[d_] = -1;
    return furthest(vertex);
  }

  // A row whose product is above zero by more than is small; else a side.
  std::uint32_t furthest(const ColumnNumbers& direction) {
    basis_.proposal_probes += body_.size();
    const FurthestPoint far = furthest_along(body_.columns(), direction);
    const std::span<const double> row = body_.row(far.index);
    double size = 0;
    for (std::size_t c = 0; c <= d_; ++c) size += std::fabs(row[c] * direction[c]);
    return far.product > small * size ? far.index : first_box_side;
  }

  bool enter(std::uint32_t entering) {
    const std::span<const double> row = body_.row(entering);
    double greatest = 0;
    for (std::size_t c = 0; c < d_; ++c) greatest = std::max(greatest, std::fabs(row[c]));
    if (!(greatest > 0) || !std::isfinite(1 / greatest)) return false;
    Numbers t{}, weight{};
    double least = 0;
    for (std::size_t i = 0; i < d_; ++i) {
      for (std::size_t j = 0; j < d_; ++j) {
        t[i] += row[j] / greatest * inverse_[j][i];
        weight[i] += objective_[j] * inverse_[j][i];
      }
      weight[i] = std::max(weight[i], 0.0);
      least = std::max(least, small * t[i]);
    }
    // Of those that keep all weights non-negative, by the perturbed objective.
    const auto leaves_before = [&](std::size_t i, std::size_t k) {
      double first = weight[i] / t[i], second = weight[k] / t[k];
      for (std::size_t j = 0; j < d_; ++j) {
        if (std::fabs(first - second) > small * (std::fabs(first) + std::fabs(second)) + 0x1p-60) break;
        first = signs_[j] * inverse_[j][i] / t[i];
        second = signs_[j] * inverse_[j][k] / t[k];
      }
      return first < second;
    };
    std::size_t r = d_;
    for (std::size_t i = 0; i < d_; ++i) {
      if (t[i] > least && t[i] > 0x1p-60 && (r == d_ || leaves_before(i, r))) r = i;
    }
    if (r == d_) return false;
    for (std::size_t j = 0; j < d_; ++j) {
      inverse_[j][r] /= t[r];
      for (std::size_t i = 0; i < d_; ++i) {
        if (i != r) inverse_[j][i] -= t[i] * inverse_[j][r];
      }
    }
    basis_.rows[r] = entering;
    levels_[r] = row[d_] / greatest;
    return true;
  }

  const Polytope& body_;
  std::size_t d_;
  RowBasis basis_;
  Numbers objective_{}, signs_{}, levels_{1, 1, 1, 1, 1, 1};  // of the basis: b, as its normals are scaled; sides: 1
  std::array<Numbers, most_dimension> inverse_{};             // row j, column i of the inverse of the basis
};

}  // namespace

RowBasis basis_by_scans(const Polytope& half_spaces, std::span<const double> objective) {
  return RoundedDualSimplex(half_spaces, objective).solve();
}

}  // namespace sunder::polytope
