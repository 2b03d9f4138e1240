#include <sunder/base/contract.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/represent/hierarchical_tree.h>
#include <sunder/predicate/point/cone_weights.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
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

TreeWalk::TreeWalk(const HierarchicalTree& tree) : tree_(&tree) {}

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

template <class ConeOf>
const HierarchicalTree::Node& TreeWalk::walk(std::size_t levels, const ConeOf& cone_of) {
  const HierarchicalTree::Node* node = &tree_->node(0);
  last_path_ = path_;
  path_.size = 0;
  bool is_as_before = true;
  while (node->cones > 0 && path_.size < levels) {
    is_as_before = is_as_before && path_.size < last_path_.size;
    const std::uint32_t from = is_as_before ? last_path_.cones[path_.size] : node->first_cone;
    const std::uint32_t cone = cone_of(*node, from);
    if (cone == no_child) {
      ++scans_;
      break;
    }
    is_as_before = is_as_before && cone == from;
    path_.cones[path_.size++] = cone;
    node = &tree_->node(tree_->child(cone));
  }
  return *node;
}

ExactFurthest TreeWalk::furthest(std::span<const Dyadic> given, Cost& cost) {
  SUNDER_REQUIRE(given.size() == tree_->body().columns().dimension);
  const std::vector<Dyadic> direction = tree_->reduced(given);
  std::array<double, most_columns> numbers{};
  const std::span<double> rounded(numbers.data(), direction.size());
  if (!round(direction, rounded)) {
    const HierarchicalTree::Node& root = tree_->node(0);
    scans_ += root.cones > 0;
    path_.size = 0;
    const std::span<const std::uint32_t> rows = tree_->rows(root);
    cost.probes += rows.size();
    cost.exact += static_cast<std::uint32_t>(rows.size());
    ExactFurthest best = named(rows[0], given);
    for (const std::uint32_t k : rows) {
      ExactFurthest other = named(k, given);
      if ((other.product - best.product).sign() == Sign::positive) best = std::move(other);
    }
    return best;
  }
  const HierarchicalTree::Node& end = walk(level_, [&](const HierarchicalTree::Node& node, std::uint32_t from) {
    return cone_of(node, from, direction, rounded, cost);
  });
  if (path_.size == level_) {
    ++cost.probes;
    return named(tree_->apex(path_.cones[level_ - 1]), given);
  }
  return named(furthest_of(tree_->rows(end), direction, rounded, cost), given);
}

// Goes across the facet beyond which the direction is furthest, as long as there is one, at most as often as there are
// cones.
template <std::size_t d>
std::uint32_t TreeWalk::likely_cone_of(const HierarchicalTree::Node& node, std::uint32_t from,
                                       const std::array<float, d>& along, Cost& cost) const {
  std::uint32_t cone = from;
  for (std::uint32_t k = 0; k < node.cones; ++k) {
    ++cost.probes;
    const std::uint32_t* const step = tree_->step(cone);
    float least = 0;
    std::uint32_t next = no_child;
    for (std::size_t i = 0; i < d; ++i) {
      float weight = 0;
      for (std::size_t c = 0; c < d; ++c) weight += std::bit_cast<float>(step[i * d + c]) * along[c];
      if (weight >= least || step[d * d + i] == no_child) continue;
      least = weight;
      next = step[d * d + i];
    }
    if (next == no_child) break;
    cone = next;
  }
  return cone;
}

template <std::size_t d>
FurthestPoint TreeWalk::likely_of_leaf(const ColumnNumbers& direction, bool of_last, Cost& cost) {
  if (!of_last || last_leaf_ == nullptr) {
    // In single precision, times a power of two, as the direction may be of any length.
    double size = 0x1p-1000;
    for (std::size_t c = 0; c < d; ++c) size = std::max(size, std::fabs(direction[c]));
    const double unit = std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 0;
    std::array<float, d> along;
    for (std::size_t c = 0; c < d; ++c) along[c] = static_cast<float>(direction[c] * unit);
    last_leaf_ = &walk(TreeOptions::most_levels, [&](const HierarchicalTree::Node& node, std::uint32_t from) {
      return likely_cone_of<d>(node, from, along, cost);
    });
  }
  const std::span<const std::uint32_t> rows = tree_->rows(*last_leaf_);
  cost.probes += rows.size();
  FurthestPoint best{rows[0], -std::numeric_limits<double>::infinity()};
  for (const std::uint32_t row : rows) {
    const double* const point = tree_->point(row).data();
    double product = direction[0] * point[0];
    for (std::size_t c = 1; c < d; ++c) product += direction[c] * point[c];
    if (product > best.product) best = {row, product};
  }
  return best;
}

FurthestPoint TreeWalk::likely_furthest(const ColumnNumbers& direction, Reach reach, Cost& cost) {
  const std::size_t d = tree_->body().columns().dimension;
  if (tree_->is_flat()) {
    level_ = tree_->depth() + 1;
    const auto end = direction.begin() + static_cast<std::ptrdiff_t>(d);
    const ExactFurthest exact = furthest(std::vector<Dyadic>(direction.begin(), end), cost);
    return {exact.index, exact.product.nearest()};
  }
  if (tree_->node(0).cones > 0 && (reach == Reach::net || path_.size == 0)) {
    const PointColumns net = tree_->net();
    cost.probes += net.count;
    const FurthestPoint of_net = furthest_along(net, direction);
    path_.cones[0] = tree_->net_cone(of_net.index);
    path_.size = 1;
    if (reach == Reach::net) return {tree_->apex(path_.cones[0]), of_net.product};
  }
  const bool of_last = reach == Reach::last_leaf;
  switch (d) {
    case 2: return likely_of_leaf<2>(direction, of_last, cost);
    case 3: return likely_of_leaf<3>(direction, of_last, cost);
    case 4: return likely_of_leaf<4>(direction, of_last, cost);
    case 5: return likely_of_leaf<5>(direction, of_last, cost);
    case 6: return likely_of_leaf<6>(direction, of_last, cost);
    default: return likely_of_leaf<7>(direction, of_last, cost);
  }
}

bool TreeWalk::was_to_the_end(const ColumnNumbers& direction, Cost& cost) const {
  if (tree_->is_flat()) return true;
  const std::size_t d = tree_->dimension();
  cost.probes += path_.size;
  return std::all_of(path().begin(), path().end(), [&](std::uint32_t cone) {
    const auto& signs = cone_weights(tree_->inverse(cone), tree_->slack(cone), std::span(direction).first(d), d).sign;
    return std::all_of(signs.begin(), signs.begin() + static_cast<std::ptrdiff_t>(d),
                       [](Guess sign) { return sign == Guess::positive; });
  });
}

}  // namespace sunder::polytope
