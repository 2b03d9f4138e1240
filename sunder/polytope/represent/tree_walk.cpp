#include <sunder/base/contract.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/represent/hierarchical_tree.h>
#include <sunder/predicate/point/cone_weights.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace sunder::polytope {

namespace {

constexpr std::uint32_t no_child = HierarchicalTree::none;
constexpr int most_steps = 64;  // across facets; then all cones of the node are looked at

Dyadic product_of(std::span<const Dyadic> direction, std::span<const double> row) {
  Dyadic sum;
  for (std::size_t c = 0; c < direction.size(); ++c) sum = sum + direction[c] * Dyadic(row[c]);
  return sum;
}

// The direction in doubles, times a power of two, each with a relative error of 2^-53 at most. False where a component
// is too small beside the others for that.
bool round(std::span<const Dyadic> direction, std::span<double> rounded) {
  bool found = false;
  std::int64_t top = 0;
  for (const Dyadic& x : direction) {
    if (x.sign() == Sign::zero) continue;
    top = found ? std::max(top, x.top()) : x.top();
    found = true;
  }
  for (std::size_t c = 0; c < direction.size(); ++c) {
    rounded[c] = 0;
    if (direction[c].sign() == Sign::zero) continue;
    if (direction[c].top() < top - 900) return false;
    rounded[c] = direction[c].scaled(-top).nearest();
  }
  return true;
}

// The signs of the exact weights of the direction.
std::array<Sign, most_columns> exact_signs(const HierarchicalTree& tree, std::uint32_t cone,
                                           std::span<const Dyadic> direction) {
  const std::size_t d = tree.dimension();
  std::array<double, most_columns * most_columns> matrix{};
  for (std::size_t r = 0; r < d; ++r) {
    for (std::size_t k = 0; k < d; ++k) matrix[r * d + k] = tree.ray(cone, k)[r];
  }
  std::array<Sign, most_columns> signs;
  signs.fill(Sign::negative);
  const auto inverse = exact_inverse(d, std::span<const double>(matrix).first(d * d));
  if (!inverse) return signs;  // flat: the directions that it has, others have
  for (std::size_t k = 0; k < d; ++k) {
    Dyadic weight;
    for (std::size_t c = 0; c < d; ++c) weight = weight + inverse->numbers[k * d + c] * direction[c];
    signs[k] = weight.sign();
  }
  return signs;
}

}  // namespace

TreeWalk::TreeWalk(const HierarchicalTree& tree) : tree_(&tree) { products_.resize(tree.largest_leaf()); }

bool TreeWalk::deepen() {
  if (level_ > tree_->depth()) return false;
  ++level_;
  return true;
}

std::uint32_t TreeWalk::cone_of(const HierarchicalTree::Node& node, std::uint32_t from,
                                std::span<const Dyadic> direction, std::span<const double> rounded, Cost& cost) const {
  const std::size_t d = tree_->dimension();
  // Has the cone the direction? If not, `out` is a ray without which a facet parts them, if one leads on.
  const auto has = [&](std::uint32_t cone, std::size_t& out) {
    ++cost.probes;
    const ConeWeights weights = cone_weights(tree_->inverse(cone), tree_->slack(cone), rounded, d);
    bool is_out = false, all_sure = true;
    double least = 0;
    out = d;
    for (std::size_t k = 0; k < d; ++k) {
      all_sure = all_sure && is_sure(weights.sign[k]);
      if (weights.sign[k] != Guess::negative) continue;
      is_out = true;
      if (weights.weight[k] < least && tree_->across(cone, k) != no_child) {
        least = weights.weight[k];
        out = k;
      }
    }
    if (is_out) return false;
    if (all_sure) return true;
    ++cost.exact;
    const std::array<Sign, most_columns> signs = exact_signs(*tree_, cone, direction);
    for (std::size_t k = 0; k < d; ++k) {
      if (signs[k] != Sign::negative) continue;
      is_out = true;
      if (tree_->across(cone, k) != no_child) out = k;
    }
    return !is_out;
  };
  std::size_t out = d;
  std::uint32_t cone = from;
  for (int step = 0; step < most_steps; ++step) {
    if (has(cone, out)) return cone;
    if (out == d) break;
    cone = tree_->across(cone, out);
  }
  for (std::uint32_t k = node.first_cone; k < node.first_cone + node.cones; ++k) {
    if (has(k, out)) return k;
  }
  return no_child;
}

std::uint32_t TreeWalk::furthest_of(std::span<const std::uint32_t> rows, std::span<const Dyadic> direction,
                                    std::span<const double> rounded, Cost& cost) {
  cost.probes += rows.size();
  if (rows.size() == 1) return rows[0];
  if (products_.size() < rows.size()) products_.resize(rows.size());
  const auto d = static_cast<double>(rounded.size());
  std::size_t best = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::span<const double> row = tree_->point(rows[k]);
    double sum = 0, sizes = 0;
    for (std::size_t c = 0; c < rounded.size(); ++c) {
      const double product = rounded[c] * row[c];
      sum += product;
      sizes += std::fabs(product);
    }
    products_[k] = {sum, (d + 4) * 0x1p-53 * sizes + 0x1p-1060};
    if (sum > products_[best].product) best = k;
  }
  std::size_t found = best;
  std::optional<Dyadic> product;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k == best || compare(products_[k], products_[best]) == Guess::positive) continue;
    ++cost.exact;
    if (!product) product = product_of(direction, tree_->point(rows[best]));
    Dyadic other = product_of(direction, tree_->point(rows[k]));
    if ((other - *product).sign() != Sign::positive) continue;
    product = std::move(other);
    found = k;
  }
  return rows[found];
}

ExactFurthest TreeWalk::named(std::uint32_t row, std::span<const Dyadic> direction) const {
  return {row, product_of(direction, tree_->body().row(row))};
}

ExactFurthest TreeWalk::furthest(std::span<const Dyadic> given, Cost& cost) {
  SUNDER_REQUIRE(given.size() == tree_->body().columns().dimension);
  const std::vector<Dyadic> direction = tree_->reduced(given);
  std::array<double, most_columns> numbers{};
  const std::span<double> rounded(numbers.data(), direction.size());
  const HierarchicalTree::Node* node = &tree_->node(0);
  std::swap(path_, last_path_);
  path_.clear();
  if (!round(direction, rounded)) {
    scans_ += node->cones > 0;
    const std::span<const std::uint32_t> rows = tree_->rows(*node);
    cost.probes += rows.size();
    cost.exact += static_cast<std::uint32_t>(rows.size());
    ExactFurthest best = named(rows[0], given);
    for (const std::uint32_t k : rows) {
      ExactFurthest other = named(k, given);
      if ((other.product - best.product).sign() == Sign::positive) best = std::move(other);
    }
    return best;
  }
  bool is_as_before = true;
  while (node->cones > 0) {
    const std::size_t level = path_.size();
    is_as_before = is_as_before && level < last_path_.size();
    const std::uint32_t from = is_as_before ? last_path_[level] : node->first_cone;
    const std::uint32_t cone = cone_of(*node, from, direction, rounded, cost);
    if (cone == no_child) {
      ++scans_;
      break;
    }
    is_as_before = is_as_before && cone == from;
    path_.push_back(cone);
    if (path_.size() == level_) {
      ++cost.probes;
      return named(tree_->apex(cone), given);
    }
    node = &tree_->node(tree_->child(cone));
  }
  return named(furthest_of(tree_->rows(*node), direction, rounded, cost), given);
}

}  // namespace sunder::polytope
