#include <sunder/base/interruption.h>
#include <sunder/base/random.h>
#include <sunder/polytope/region/program_search_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

  RowBasis by_scans() {
    const std::size_t most_steps = 60 * d_;
    while (body_.size() > 0 && basis_.steps < most_steps) {
      may_be_interrupted(1000);
      const std::uint32_t entering = most_broken();
      if (entering >= first_box_side || enter(entering) == d_) break;
    }
    return basis_;
  }

  RowBasis by_seidel() {
    Random random(21);
    order_.resize(body_.size());
    for (std::uint32_t k = 0; k < body_.size(); ++k) order_[k] = k;
    for (std::size_t k = order_.size(); k > 1; --k) std::swap(order_[k - 1], order_[random.below(k)]);
    find_vertex();
    add_first(order_.size());
    return basis_;
  }

 private:
  using Numbers = std::array<double, most_dimension>;

  bool is_side(std::size_t i) const { return basis_.rows[i] >= first_box_side; }

  // The best point of the first rows of the order, on the rows that are fixed; from a basis that has these. Where the
  // best point so far is outside of the next row, that is fixed, and the rows before it are gone through once more, in
  // one dimension less. False where there is no such point, as floating point has it.
  // NOLINTNEXTLINE(misc-no-recursion): d levels
  bool add_first(std::size_t count) {
    for (std::size_t k = 0; k < count && fixed_ < d_; ++k) {
      ++basis_.proposal_probes;
      if (!is_broken(order_[k])) continue;
      const std::size_t r = enter(order_[k]);
      if (r == d_) return false;
      find_vertex();
      is_fixed_[r] = true;
      ++fixed_;
      const bool found = add_first(k);
      is_fixed_[r] = false;
      --fixed_;
      if (!found) return false;
    }
    return true;
  }

  void find_vertex() {
    vertex_ = {};
    way_ = {};
    at_box_ = false;
    for (std::size_t i = 0; i < d_; ++i) {
      at_box_ = at_box_ || is_side(i);
      for (std::size_t j = 0; j < d_; ++j) (is_side(i) ? way_ : vertex_)[j] += inverse_[j][i] * levels_[i];
    }
    if (at_box_) {
      double length = 0, size = 1;
      for (std::size_t j = 0; j < d_; ++j) {
        length = std::max(length, std::fabs(way_[j]));
        size = std::max(size, std::fabs(vertex_[j]));
      }
      const double far = size * 0x1p+12 / length;
      for (std::size_t j = 0; j < d_; ++j) vertex_[j] += far * way_[j];
    }
    vertex_[d_] = -1;
  }

  bool is_above(std::span<const double> row, const ColumnNumbers& direction) const {
    double product = 0, size = 0;
    for (std::size_t c = 0; c <= d_; ++c) {
      const double part = row[c] * direction[c];
      product += part;
      size += std::fabs(part);
    }
    return product > small * size;
  }

  bool is_broken(std::uint32_t k) const {
    const std::span<const double> row = body_.row(k);
    return (at_box_ && is_above(row, way_)) || is_above(row, vertex_);
  }

  // The row that is broken most; else a side.
  std::uint32_t most_broken() {
    find_vertex();
    const std::uint32_t along = at_box_ ? furthest(way_) : first_box_side;
    return along < first_box_side ? along : furthest(vertex_);
  }

  std::uint32_t furthest(const ColumnNumbers& direction) {
    basis_.proposal_probes += body_.size();
    const FurthestPoint far = furthest_along(body_.columns(), direction);
    return is_above(body_.row(far.index), direction) ? far.index : first_box_side;
  }

  // Returns where; d where none can leave.
  std::size_t enter(std::uint32_t entering) {
    const std::span<const double> row = body_.row(entering);
    double greatest = 0;
    for (std::size_t c = 0; c < d_; ++c) greatest = std::max(greatest, std::fabs(row[c]));
    if (!(greatest > 0) || !std::isfinite(1 / greatest)) return d_;
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
      if (!is_fixed_[i] && t[i] > least && t[i] > 0x1p-60 && (r == d_ || leaves_before(i, r))) r = i;
    }
    if (r == d_) return d_;
    for (std::size_t j = 0; j < d_; ++j) {
      inverse_[j][r] /= t[r];
      for (std::size_t i = 0; i < d_; ++i) {
        if (i != r) inverse_[j][i] -= t[i] * inverse_[j][r];
      }
    }
    basis_.rows[r] = entering;
    levels_[r] = row[d_] / greatest;
    ++basis_.steps;
    return r;
  }

  const Polytope& body_;
  std::size_t d_;
  RowBasis basis_;
  Numbers objective_{}, signs_{}, levels_{1, 1, 1, 1, 1, 1};  // of the basis: b, as its normals are scaled; sides: 1
  std::array<Numbers, most_dimension> inverse_{};             // row j, column i of the inverse of the basis
  ColumnNumbers vertex_{}, way_{};                            // the first, where at_box_, far along the way; then -1; 0
  bool at_box_ = true;
  std::vector<std::uint32_t> order_;
  std::array<bool, most_dimension> is_fixed_{};
  std::size_t fixed_ = 0;
};

}  // namespace

RowBasis basis_by_scans(const Polytope& half_spaces, std::span<const double> objective) {
  return RoundedDualSimplex(half_spaces, objective).by_scans();
}

RowBasis basis_by_seidel(const Polytope& half_spaces, std::span<const double> objective) {
  return RoundedDualSimplex(half_spaces, objective).by_seidel();
}

}  // namespace sunder::polytope
