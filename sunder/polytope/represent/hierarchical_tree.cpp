#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/base/random.h>
#include <sunder/polytope/represent/hierarchical_tree.h>
#include <sunder/polytope/represent/normal_fan.h>
#include <sunder/predicate/point/cone_weights.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace sunder::polytope {

namespace {

using Numbers = NormalFan::Numbers;
using Rows = std::vector<std::uint32_t>;

constexpr std::uint32_t none = HierarchicalTree::none;
constexpr std::array<std::uint32_t, most_columns + 1> net_of_dimension{0, 0, 8, 16, 32, 16, 12, 11};
constexpr std::array<std::uint32_t, most_columns + 1> leaf_of_dimension{0, 0, 8, 24, 96, 40, 56, 64};
constexpr std::array<double, most_columns + 1> share_of_dimension{0, 0, 0.5, 0.5, 0.5, 0.75, 0.85, 0.9};

// A cone with its rays and the inverse of their matrix.
struct Cone {
  std::uint32_t apex = 0;  // a row
  Numbers rays{}, across{};
  std::vector<double> generators, inverse;  // d d each
  double slack = 0;
};

// Does a facet of the second cone part the two, surely?
bool is_beside(const Cone& first, const Cone& second, std::size_t d) {
  std::array<bool, most_columns> is_out;
  is_out.fill(true);
  for (std::size_t k = 0; k < d; ++k) {
    const ConeWeights weights =
        cone_weights(second.inverse, second.slack, std::span(first.generators).subspan(k * d, d), d);
    for (std::size_t i = 0; i < d; ++i) is_out[i] = is_out[i] && weights.sign[i] == Guess::negative;
  }
  return std::any_of(is_out.begin(), is_out.begin() + static_cast<std::ptrdiff_t>(d), [](bool out) { return out; });
}

// The cones of a net of rows, with the lists of their children.
struct Split {
  std::vector<double> rays;  // d each
  std::vector<Cone> cones;
  std::vector<Rows> lists;
  std::vector<std::size_t> conflicts;  // of each cone, before the list is thinned
  std::size_t most_conflicts = 0;
};

}  // namespace

class TreeBuilder {
 public:
  TreeBuilder(HierarchicalTree& tree, const TreeOptions& options)
      : tree_(tree), body_(tree.body_), options_(options), random_(options.seed) {}

  void build() {
    Rows rows = distinct_rows();
    find_flat(rows);
    if (d_ == 1) {  // a segment, whose ends are all
      const auto [first, last] = std::minmax_element(rows.begin(), rows.end(), [&](std::uint32_t i, std::uint32_t j) {
        return tree_.point(i)[0] < tree_.point(j)[0];
      });
      rows = {*first, *last};
    }
    of_half_spaces_ = !body_.is_of_points() && !tree_.is_flat();
    const auto d = static_cast<std::uint32_t>(d_);
    net_ = options_.net == 0 ? net_of_dimension[d_] : std::max(options_.net, d + 2);
    leaf_ = options_.leaf == 0 ? leaf_of_dimension[d_] : options_.leaf;
    share_ = options_.share == 0 ? share_of_dimension[d_] : options_.share;
    tree_.nodes_.emplace_back();
    grow(0, std::move(rows), nullptr, 0);
    list_net();
    list_steps();
  }

 private:
  Rows distinct_rows() const {
    Rows rows(body_.size());
    std::iota(rows.begin(), rows.end(), 0u);
    const auto less = [&](std::uint32_t i, std::uint32_t j) {
      const std::span<const double> a = body_.row(i), b = body_.row(j);
      if (!std::equal(a.begin(), a.end(), b.begin())) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
      }
      return i < j;
    };
    std::sort(rows.begin(), rows.end(), less);
    const auto same = [&](std::uint32_t i, std::uint32_t j) {
      return std::equal(body_.row(i).begin(), body_.row(i).end(), body_.row(j).begin());
    };
    rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
    return rows;
  }

  void find_flat(const Rows& rows) {
    AffineColumns flat =
        affine_columns(body_.columns().dimension, rows.size(), [&](std::size_t k) { return body_.row(rows[k]); });
    d_ = tree_.d_ = flat.columns.size();
    if (!tree_.is_flat()) return;
    for (std::uint32_t k = 0; k < body_.size(); ++k) {
      for (const AffineColumns::Column& column : flat.columns) tree_.points_.push_back(body_.row(k)[column.column]);
    }
    tree_.flat_ = std::move(flat);
  }

  void grow(std::uint32_t node, Rows rows, const Cone* within, std::uint32_t depth) {
    tree_.depth_ = std::max(tree_.depth_, depth);
    tree_.nodes_[node].first_row = static_cast<std::uint32_t>(tree_.rows_.size());
    tree_.nodes_[node].rows = static_cast<std::uint32_t>(rows.size());
    tree_.rows_.insert(tree_.rows_.end(), rows.begin(), rows.end());
    const auto most = static_cast<std::size_t>(share_ * static_cast<double>(rows.size()));
    std::optional<Split> split;
    if (d_ >= 2 && rows.size() > leaf_ && rows.size() > d_ + 2 && depth < options_.levels)
      split = best_split(rows, within, most);
    if (!split) {
      ++tree_.leaf_count_;
      tree_.largest_leaf_ = std::max(tree_.largest_leaf_, static_cast<std::uint32_t>(rows.size()));
      return;
    }
    add_cones(node, *split);
    if (depth == 0) {
      tree_.estimate_ = estimate(*split, rows.size());
      for (const std::size_t count : split->conflicts) tree_.root_conflicts_ += count;
    }
    refuse_more_than_may_be(std::max(tree_.estimate_, tree_.memory()), depth == 0);
    rows = {};
    const std::uint32_t first = tree_.nodes_[node].first_cone;
    for (std::uint32_t k = 0; k < split->cones.size(); ++k) {
      Rows list = std::move(split->lists[k]);
      if (split->conflicts[k] > most) ++tree_.unverified_;
      children_[first + k] = static_cast<std::uint32_t>(tree_.nodes_.size());
      tree_.nodes_.emplace_back();
      const std::uint32_t child = children_[first + k];
      if (list.size() > std::max<std::size_t>(most, leaf_)) {  // no progress: a large leaf
        add_leaf(child, list);
      } else {
        grow(child, std::move(list), &split->cones[k], depth + 1);
      }
    }
    tree_.depth_ = std::max(tree_.depth_, depth + 1);
  }

  void add_leaf(std::uint32_t node, const Rows& rows) {
    tree_.nodes_[node].first_row = static_cast<std::uint32_t>(tree_.rows_.size());
    tree_.nodes_[node].rows = static_cast<std::uint32_t>(rows.size());
    tree_.rows_.insert(tree_.rows_.end(), rows.begin(), rows.end());
    ++tree_.leaf_count_;
    tree_.largest_leaf_ = std::max(tree_.largest_leaf_, static_cast<std::uint32_t>(rows.size()));
  }

  // Samples until a net is verified; else the best of them, if its children have no more in the mean.
  std::optional<Split> best_split(const Rows& rows, const Cone* within, std::size_t most) {
    std::optional<Split> best;
    for (std::uint32_t k = 0; k < options_.samples; ++k) {
      // Where the first samples are far from it, others are, too.
      if (k == 8 && (!best || best->most_conflicts > (most + rows.size()) / 2)) break;
      ++tree_.samples_;
      // Larger nets after some. General position is made by noise: little, or much, which makes rows that are nearly
      // flat round.
      std::optional<Split> split =
          split_by_net(sample(rows, net_ + k / 8 * net_ / 4), rows, within, k % 8 < 4 ? 0x1p-24 : 0x1p-5);
      if (!split) continue;
      if (!best || split->most_conflicts < best->most_conflicts) best = std::move(split);
      if (best->most_conflicts <= most) return best;
    }
    if (!best) return best;
    std::size_t sum = 0;
    for (const Rows& list : best->lists) sum += list.size();
    return sum <= most * best->lists.size() ? std::move(best) : std::nullopt;
  }

  Rows sample(const Rows& rows, std::size_t size) {
    Rows some = rows;
    const std::size_t count = std::min(size, rows.size());
    for (std::size_t k = 0; k < count; ++k) std::swap(some[k], some[k + random_.below(some.size() - k)]);
    some.resize(count);
    return some;
  }

  std::optional<Split> split_by_net(const Rows& net, const Rows& rows, const Cone* within, double noise) {
    // Columns in units of their extent.
    std::array<double, most_columns> low{}, extent{};
    std::array<int, most_columns> unit{};
    int least = std::numeric_limits<int>::max(), greatest = std::numeric_limits<int>::min();
    for (std::size_t c = 0; c < d_; ++c) {
      double high = -std::numeric_limits<double>::infinity();
      low[c] = -high;
      for (const std::uint32_t k : rows) {
        low[c] = std::min(low[c], tree_.point(k)[c]);
        high = std::max(high, tree_.point(k)[c]);
      }
      extent[c] = high - low[c];
      if (!std::isfinite(extent[c])) return std::nullopt;
      if (extent[c] <= 0) continue;
      unit[c] = std::ilogb(extent[c]);
      least = std::min(least, unit[c]);
      greatest = std::max(greatest, unit[c]);
    }
    if (least > greatest || greatest - least > 400) return std::nullopt;
    std::vector<double> points;
    for (const std::uint32_t k : net) {
      for (std::size_t c = 0; c < d_; ++c) {
        if (extent[c] <= 0) unit[c] = greatest;
        points.push_back(std::ldexp(tree_.point(k)[c] - low[c], -unit[c]) - 0.5 + noise * (2 * random_.unit() - 1));
      }
    }
    std::uint64_t looks = 0;
    const std::optional<NormalFan> fan = normal_fan(d_, points, looks);
    count_looks(looks);
    if (!fan) return std::nullopt;
    Split split;
    split.rays = fan->rays;
    for (std::size_t k = 0; k < split.rays.size(); ++k) {
      split.rays[k] = std::ldexp(split.rays[k], greatest - unit[k % d_]);
    }
    std::vector<std::uint32_t> kept(fan->cones.size(), none);
    for (std::uint32_t k = 0; k < fan->cones.size(); ++k) {
      const NormalFan::Cone& from = fan->cones[k];
      Cone cone;
      cone.apex = net[from.apex];
      cone.rays = from.rays;
      cone.across = from.across;
      for (std::size_t i = 0; i < d_; ++i) {
        const auto begin = split.rays.begin() + static_cast<std::ptrdiff_t>(from.rays[i] * d_);
        cone.generators.insert(cone.generators.end(), begin, begin + static_cast<std::ptrdiff_t>(d_));
      }
      cone.inverse.resize(d_ * d_);
      cone.slack = cone_inverse(cone.generators, d_, cone.inverse);
      if (of_half_spaces_ && is_of_no_point(cone)) continue;
      if (within != nullptr) count_looks(2);
      if (within != nullptr && (is_beside(cone, *within, d_) || is_beside(*within, cone, d_))) continue;
      kept[k] = static_cast<std::uint32_t>(split.cones.size());
      split.cones.push_back(std::move(cone));
    }
    if (split.cones.empty()) return std::nullopt;
    for (Cone& cone : split.cones) {
      for (std::size_t i = 0; i < d_; ++i) cone.across[i] = kept[cone.across[i]];
      list_conflicts(cone, rows, split);
    }
    return split;
  }

  // Of half-spaces, (p, -w) with a w below zero?
  bool is_of_no_point(const Cone& cone) const {
    bool is_none = true;
    for (std::size_t i = 0; i < d_; ++i) is_none = is_none && cone.generators[i * d_ + d_ - 1] > 0;
    return is_none;
  }

  // Of half-spaces, is the row kept by all points of the cone, surely?
  bool is_kept(const Cone& cone, std::uint32_t row) const {
    const std::array<double, most_columns> zero{};
    for (std::size_t i = 0; i < d_; ++i) {
      const std::span<const double> generator = std::span(cone.generators).subspan(i * d_, d_);
      if (difference_along(generator, tree_.point(row), std::span(zero).first(d_)).most > 0) return false;
    }
    return true;
  }

  // The rows out of the shell-simplex, less those that others are as far as; and the apex.
  void list_conflicts(const Cone& cone, const Rows& rows, Split& split) {
    struct Candidate {
      std::uint32_t row;
      double total;
      std::array<ProductRange, most_columns> along;
    };
    std::vector<Candidate> candidates;
    const std::span<const double> apex = tree_.point(cone.apex);
    std::size_t conflicts = 0;
    count_looks(rows.size());
    for (const std::uint32_t k : rows) {
      Candidate candidate{k, 0, {}};
      bool is_out = false;
      for (std::size_t i = 0; i < d_; ++i) {
        candidate.along[i] = difference_along(std::span(cone.generators).subspan(i * d_, d_), tree_.point(k), apex);
        candidate.total += (candidate.along[i].least + candidate.along[i].most) / 2;
        is_out = is_out || candidate.along[i].most > 0;
      }
      if (k != cone.apex && (!is_out || (of_half_spaces_ && is_kept(cone, k)))) continue;
      conflicts += is_out;
      if (!(std::fabs(candidate.total) <= std::numeric_limits<double>::max())) candidate.total = 0;
      candidates.push_back(candidate);
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.total != b.total ? a.total > b.total : a.row < b.row;
    });
    const auto is_as_far = [&](const Candidate& a, const Candidate& b) {
      for (std::size_t i = 0; i < d_; ++i) {
        if (!(a.along[i].least >= b.along[i].most)) return false;
      }
      return true;
    };
    std::vector<Candidate> ends;
    std::uint64_t compared = 0;
    for (const Candidate& candidate : candidates) {
      const auto lost_to =
          std::find_if(ends.begin(), ends.end(), [&](const Candidate& end) { return is_as_far(end, candidate); });
      compared += static_cast<std::uint64_t>(lost_to - ends.begin()) + 1;
      may_be_interrupted(1 + static_cast<std::uint32_t>(lost_to - ends.begin()) / 16);
      if (lost_to == ends.end()) {
        ends.push_back(candidate);
      } else if (lost_to != ends.begin()) {
        std::swap(*lost_to, *(lost_to - 1));  // who beats many comes to the front
      }
    }
    count_looks(compared / 64);
    Rows list;
    for (const Candidate& end : ends) list.push_back(end.row);
    split.lists.push_back(std::move(list));
    split.conflicts.push_back(conflicts);
    split.most_conflicts = std::max(split.most_conflicts, conflicts);
  }

  void add_cones(std::uint32_t node, const Split& split) {
    const auto first = static_cast<std::uint32_t>(children_.size());
    const auto first_ray = static_cast<std::uint32_t>(tree_.rays_.size() / d_);
    tree_.nodes_[node].first_cone = first;
    tree_.nodes_[node].cones = static_cast<std::uint32_t>(split.cones.size());
    tree_.rays_.insert(tree_.rays_.end(), split.rays.begin(), split.rays.end());
    for (const Cone& cone : split.cones) {
      children_.push_back(none);
      tree_.apexes_.push_back(cone.apex);
      tree_.slacks_.push_back(cone.slack);
      tree_.inverses_.insert(tree_.inverses_.end(), cone.inverse.begin(), cone.inverse.end());
      for (std::size_t i = 0; i < d_; ++i) {
        across_.push_back(cone.across[i] == none ? none : first + cone.across[i]);
        tree_.cone_rays_.push_back(first_ray + cone.rays[i]);
      }
    }
  }

  // The apexes of the root's cones.
  void list_net() {
    const HierarchicalTree::Node& root = tree_.nodes_[0];
    std::vector<std::uint32_t> net;
    for (std::uint32_t cone = 0; root.cones > 0 && cone < root.cones; ++cone) {
      const std::uint32_t row = tree_.apexes_[root.first_cone + cone];
      if (std::find(net.begin(), net.end(), row) != net.end()) continue;
      net.push_back(row);
      tree_.net_cones_.push_back(root.first_cone + cone);
    }
    tree_.net_stride_ = (net.size() + PointColumns::block - 1) / PointColumns::block * PointColumns::block;
    for (std::size_t c = 0; c < d_; ++c) {
      for (std::size_t k = 0; k < tree_.net_stride_; ++k) {
        tree_.net_.push_back(tree_.point(net[std::min(k, net.size() - 1)])[c]);
      }
    }
  }

  void list_steps() {
    const std::size_t square = d_ * d_;
    for (std::size_t cone = 0; cone < children_.size(); ++cone) {
      for (std::size_t i = 0; i < d_; ++i) {
        const std::span<const double> row = std::span(tree_.inverses_).subspan(cone * square + i * d_, d_);
        double size = 0;
        for (const double x : row) size = std::max(size, std::fabs(x));
        for (const double x : row) {
          tree_.steps_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(size > 0 ? x / size : x)));
        }
      }
      for (std::size_t i = 0; i < d_; ++i) tree_.steps_.push_back(across_[cone * d_ + i]);
      tree_.steps_.push_back(children_[cone]);
    }
  }

  // The lists of the root tell how many children a node has, and which part of its rows each; the levels below them are
  // taken to be alike.
  std::size_t estimate(const Split& split, std::size_t rows) const {
    double sum = 0;
    for (const Rows& list : split.lists) sum += static_cast<double>(list.size());
    const auto cones = static_cast<double>(split.cones.size());
    const double part = std::min(sum / cones / static_cast<double>(rows), share_);
    const auto d = static_cast<double>(d_);
    const double cone_bytes = 8 * d * d + 8 * d + 16 + sizeof(HierarchicalTree::Node);
    const double most = std::max(share_ * static_cast<double>(rows), static_cast<double>(leaf_));
    double bytes = 4 * static_cast<double>(rows) + cones * cone_bytes;
    for (const Rows& list : split.lists) {
      double nodes = 1, size = static_cast<double>(list.size());
      for (std::uint32_t level = 1; size > leaf_ && size <= most && level < options_.levels; size *= part, ++level) {
        bytes += nodes * (4 * size + cones * cone_bytes);
        nodes *= cones;
      }
      bytes += nodes * 4 * size;
    }
    return static_cast<std::size_t>(std::min(bytes, 0x1p60));
  }

  void refuse_more_than_may_be(std::size_t bytes, bool is_estimate) const {
    if (bytes <= options_.most_bytes) return;
    const auto mebibytes = [](std::size_t n) { return std::to_string((n + (1u << 20) - 1) >> 20) + " MiB"; };
    refuse((is_estimate ? "about " : "at least ") + mebibytes(bytes) + ", more than the " +
           mebibytes(options_.most_bytes));
  }

  void count_looks(std::uint64_t count) {
    may_be_interrupted(static_cast<std::uint32_t>(std::min<std::uint64_t>(count, 1u << 30)));
    tree_.looks_ += count;
    if (tree_.looks_ <= options_.most_looks) return;
    refuse("more than the " + std::to_string(options_.most_looks) + " looks at its cones and rows");
  }

  [[noreturn]] void refuse(const std::string& takes) const {
    throw Error(ErrorCode::bad_shape, "the tree of " + std::to_string(body_.size()) + " rows of dimension " +
                                          std::to_string(body_.dimension()) + " takes " + takes +
                                          " that it may; give fewer rows, or use another method");
  }

  HierarchicalTree& tree_;
  const Polytope& body_;
  std::vector<std::uint32_t> children_, across_;  // of cones
  std::size_t d_ = 0;
  TreeOptions options_;
  Random random_;
  std::uint32_t net_ = 0, leaf_ = 0;
  double share_ = 0;
  bool of_half_spaces_ = false;  // of half-spaces, whose products with a direction tell which are broken
};

HierarchicalTree::HierarchicalTree(Polytope body, const TreeOptions& options) : body_(std::move(body)) {
  SUNDER_REQUIRE(options.share >= 0 && options.share < 1);
  SUNDER_REQUIRE(options.levels <= TreeOptions::most_levels);
  TreeBuilder(*this, options).build();
}

std::vector<Dyadic> HierarchicalTree::reduced(std::span<const Dyadic> direction) const {
  return is_flat() ? flat_.reduced(direction) : std::vector<Dyadic>(direction.begin(), direction.end());
}

std::vector<std::size_t> HierarchicalTree::columns() const {
  std::vector<std::size_t> result;
  for (const AffineColumns::Column& column : flat_.columns) result.push_back(column.column);
  return result;
}

std::size_t HierarchicalTree::memory() const {
  const auto bytes = [](const auto& list) { return list.size() * sizeof(list[0]); };
  return bytes(nodes_) + bytes(rows_) + bytes(steps_) + bytes(apexes_) + bytes(slacks_) + bytes(inverses_) +
         bytes(cone_rays_) + bytes(rays_) + bytes(points_);
}

}  // namespace sunder::polytope
