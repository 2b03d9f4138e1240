#include <sunder/polytope/pair/half_space_weights.h>
#include <sunder/polytope/pair/null_vector_internal.h>
#include <sunder/polytope/pair/wide_game.h>
#include <sunder/polytope/pair/wide_search.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

constexpr std::int64_t more_bits = 128;  // than exponents differ by, or twice, or four times that
constexpr std::int64_t wide = 256;       // exponents that differ by less are left to doubles, and to integers
constexpr std::uint32_t first_items = 32;
constexpr std::uint64_t most_products = 1'000'000;  // of all games; what has no proof by then is left to integers

// By how much the exponents of a body's numbers differ.
std::int64_t exponent_range(const Polytope& body) {
  int least = 0, greatest = 0;
  bool is_first = true;
  for (std::uint32_t k = 0; k < body.size(); ++k) {
    for (const double x : body.row(k)) {
      if (x == 0) continue;
      const int exponent = std::ilogb(x);
      least = is_first ? exponent : std::min(least, exponent);
      greatest = is_first ? exponent : std::max(greatest, exponent);
      is_first = false;
    }
  }
  return greatest - least;
}

class WideSearch {
 public:
  WideSearch(Placed& half_spaces, Placed& points, std::int64_t bits, Cost& cost)
      : half_spaces_(half_spaces), points_(points), to_{bits}, d_(points.dimension()), cost_(cost), game_(bits) {
    for (std::uint32_t k = 0; k < std::min(points.body().size(), first_items); ++k) add_point(k);
    for (std::uint32_t k = 0; k < std::min(half_spaces.body().size(), first_items); ++k) add_half_space(k);
  }

  // Until so many products are made.
  std::optional<ExactDecision> search(std::uint64_t most) {
    while (game_.products() < most && game_.solve()) {
      ++cost_.iterations;
      if (game_.columns_win()) {
        const auto broken = half_space_broken();
        if (!broken) return met();
        add_half_space(*broken);
      } else {
        std::vector<Weights::Part> weights;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
          const Dyadic& weight = game_.weights()[i];
          if (weight.sign() == Sign::positive) weights.push_back({rows_[i].index, weight});
        }
        if (auto held = parted_by_weights(half_spaces_, points_, weights, cost_)) return held;
        const auto furthest = point_against(weights);
        if (!furthest) return std::nullopt;
        add_point(*furthest);
      }
    }
    return std::nullopt;
  }
  std::uint64_t products() const { return game_.products(); }

 private:
  struct Item {
    std::uint32_t index = 0;
    ExactVector at;
  };

  static bool has(const std::vector<Item>& items, std::uint32_t index) {
    return std::any_of(items.begin(), items.end(), [&](const Item& item) { return item.index == index; });
  }
  Dyadic payoff(const Item& row, const Item& column) const { return dot(row.at, column.at) - row.at[d_]; }
  void add_half_space(std::uint32_t k) {
    rows_.push_back({k, half_spaces_.half_space(k)});
    game_.add_row([&](std::size_t j) { return payoff(rows_.back(), columns_[j]); });
  }
  void add_point(std::uint32_t k) {
    columns_.push_back({k, points_.image(k)});
    game_.add_column([&](std::size_t i) { return payoff(rows_[i], columns_.back()); });
  }

  // The half-space that the point which the columns win by breaks most, if it is a new one.
  std::optional<std::uint32_t> half_space_broken() {
    ExactVector x(d_);
    Dyadic total;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const Dyadic& weight = game_.weights()[j];
      if (weight.sign() != Sign::positive) continue;
      total = to_.sum(total, weight);
      for (std::size_t c = 0; c < d_; ++c) x[c] = to_.sum(x[c], to_.product(weight, columns_[j].at[c]));
    }
    const auto broken = half_spaces_.most_broken(x, total, cost_);
    if (!broken || broken->product.sign() != Sign::positive || has(rows_, broken->index)) return std::nullopt;
    return broken->index;
  }

  // The point that is furthest in this combination of half-spaces, if it is a new one.
  std::optional<std::uint32_t> point_against(const std::vector<Weights::Part>& weights) {
    ExactVector direction(d_);
    for (const auto& [index, weight] : weights) {
      const ExactVector row = half_spaces_.half_space(index);
      for (std::size_t c = 0; c < d_; ++c) direction[c] = to_.difference(direction[c], to_.product(weight, row[c]));
    }
    const std::uint32_t index = points_.furthest(direction, cost_).index;
    if (has(columns_, index)) return std::nullopt;
    return index;
  }

  // The weights of those points that put their sum on the boundaries of the tight half-spaces, exactly.
  std::optional<ExactDecision> met() {
    std::vector<Weights::Part> weights;
    std::vector<ExactVector> payoffs;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (game_.weights()[j].sign() != Sign::positive) continue;
      weights.push_back({columns_[j].index, {}});
      payoffs.emplace_back();
      for (const std::size_t i : game_.tight()) payoffs.back().push_back(payoff(rows_[i], columns_[j]));
    }
    if (payoffs.empty() || payoffs.size() > most_vectors || game_.tight().size() > most_dimension) return std::nullopt;
    if (payoffs.size() > game_.tight().size() + 1) return std::nullopt;
    auto numbers = null_vector(payoffs);
    if (!numbers) return std::nullopt;
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k].numerator = dyadic_of(std::move((*numbers)[k]), 0);
    return met_by_weights(half_spaces_, points_, weights, cost_);
  }

  Placed &half_spaces_, &points_;
  LongFloats to_;
  std::size_t d_;
  Cost& cost_;
  std::vector<Item> rows_, columns_;
  WideGame game_;
};

}  // namespace

std::optional<ExactDecision> search_widely(Placed& half_spaces, Placed& points, Cost& cost) {
  const std::int64_t range = exponent_range(half_spaces.body()) + exponent_range(points.body());
  if (range < wide) return std::nullopt;
  std::uint64_t products = 0;
  for (std::int64_t times = 1; times <= 4 && products < most_products; times *= 2) {
    WideSearch search(half_spaces, points, times * range + more_bits, cost);
    if (auto held = search.search(most_products - products)) return held;
    products += search.products();
  }
  return std::nullopt;
}

}  // namespace sunder::polytope
