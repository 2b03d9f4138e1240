#include <sunder/polytope/pair/candidate_rows.h>
#include <sunder/polytope/pair/half_space_point_game.h>
#include <sunder/polytope/pair/half_space_weights.h>
#include <sunder/polytope/pair/matrix_game.h>
#include <sunder/polytope/pair/null_vector_internal.h>
#include <sunder/polytope/pair/rounded_half_spaces.h>
#include <sunder/polytope/pair/support.h>
#include <sunder/polytope/pair/wide_search.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

constexpr double payoff_matters = 0x1p-30;  // of weights, and of the greatest payoff: less may be roundings
constexpr double about_zero = 0x1p-40;      // of the greatest payoff: more is not taken for a point on a boundary

class GameSearch {
 public:
  GameSearch(const Polytope& half_spaces, const Pose& pose, const Polytope& points, const Pose& pose_of_points,
             Cost& cost)
      : half_spaces_(half_spaces, pose),
        points_(points, pose_of_points),
        rounded_(half_spaces, pose),
        d_(points.dimension()),
        cost_(cost) {}

  // `of_a` are half-spaces, `of_b` points.
  HalfSpaceProposal propose() {
    HalfSpaceProposal result;
    if (rounded_.is_usable()) {
      result.decision = search();
      if (!result.decision) result.decision = tight();
    }
    if (!result.decision) result.decision = search_widely(half_spaces_, points_, cost_);
    if (result.decision) return result;
    for (std::size_t i = 0; i < game_.rows(); ++i) {
      if (game_.row_weight(i) > payoff_matters) result.of_a.push_back(rows_[i].index);
    }
    for (std::size_t j = 0; j < game_.columns(); ++j) {
      if (game_.column_weight(j) > payoff_matters) result.of_b.push_back(columns_[j].index);
    }
    return result;
  }

 private:
  struct Item {
    std::uint32_t index = 0;
    ColumnNumbers at{};  // in the world
  };

  bool has(const std::vector<Item>& items, std::uint32_t index) const {
    return std::any_of(items.begin(), items.end(), [&](const Item& item) { return item.index == index; });
  }

  double payoff(const Item& row, const Item& column) const {
    double sum = -row.at[d_];
    for (std::size_t c = 0; c < d_; ++c) sum += row.at[c] * column.at[c];
    return sum;
  }

  Item point(std::uint32_t k) const { return {k, rounded_image(points_.body(), points_.pose(), k)}; }
  void add_row(std::uint32_t k) {
    rows_.push_back({k, rounded_.row(k)});
    game_.add_row([&](std::size_t j) { return payoff(rows_.back(), columns_[j]); });
  }
  void add_column(std::uint32_t k) {
    columns_.push_back(point(k));
    game_.add_column([&](std::size_t i) { return payoff(rows_[i], columns_.back()); });
  }

  std::optional<ExactDecision> search() {
    add_column(0);
    CandidateRowsOfBoth candidates(half_spaces_.body(), points_.body());
    add_row(rounded_.most_broken(columns_[0].at, 1, candidates.a, cost_).index);
    std::optional<std::uint32_t> tried;  // half-space that alone had weight
    while (game_.rows() < MatrixGame::most && game_.columns() < MatrixGame::most) {
      if (!game_.solve()) return std::nullopt;
      ColumnNumbers x{}, direction{};
      double offset = 0;
      for (std::size_t j = 0; j < columns_.size(); ++j) {
        for (std::size_t c = 0; c < d_; ++c) x[c] += game_.column_weight(j) * columns_[j].at[c];
      }
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        for (std::size_t c = 0; c < d_; ++c) direction[c] += game_.row_weight(i) * rows_[i].at[c];
        offset += game_.row_weight(i) * rows_[i].at[d_];
      }
      const FurthestPoint broken = rounded_.most_broken(x, 1, candidates.a, cost_);
      const FurthestPoint least = likely_support(candidates.b, points_.pose(), direction, -1, cost_);
      ++cost_.iterations;
      const std::optional<std::uint32_t> only = half_space_reached(least.product - offset);
      const bool may_touch = only && only != tried;
      if ((broken.product < 0 || least.product > offset || may_touch) && candidates.widen()) continue;
      if (broken.product < 0) {
        if (auto held = inside(weights_of_points(0))) return held;
      }
      if (may_touch) {
        if (auto held = decide_at(*only)) return held;
        tried = only;
      } else if (least.product > offset) {
        if (auto held = parted(weights_of_half_spaces(0))) return held;
      }
      const bool new_row = !has(rows_, broken.index), new_column = !has(columns_, least.index);
      if (!new_row && !new_column) {
        if (candidates.widen()) continue;
        game_.solve_anew();
        return std::nullopt;
      }
      if (new_row) add_row(broken.index);
      if (new_column) add_column(least.index);
      candidates.narrow();
    }
    return std::nullopt;
  }

  // The half-space that alone has weight, where the points reach just to its boundary, as far as doubles tell.
  std::optional<std::uint32_t> half_space_reached(double least_payoff) const {
    std::optional<std::size_t> only;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!(game_.row_weight(i) > payoff_matters)) continue;
      if (only) return std::nullopt;
      only = i;
    }
    if (!only) return std::nullopt;
    double greatest = 0;
    for (const Item& column : columns_) greatest = std::max(greatest, std::fabs(payoff(rows_[*only], column)));
    if (!(std::fabs(least_payoff) <= greatest * payoff_matters)) return std::nullopt;
    return rows_[*only].index;
  }

  // Is no point in the half-space? Or is there a point in its boundary, and in all others?
  std::optional<ExactDecision> decide_at(std::uint32_t half_space) {
    ExactVector normal = half_spaces_.half_space(half_space);
    const Dyadic side = std::move(normal.back());
    normal.pop_back();
    const ExactFace face = points_.face(negated(normal), cost_);
    const Sign gap = (-face.product - side).sign();
    if (gap == Sign::positive) {
      ++cost_.proposals;
      ExactEvidence parting{.numbers = std::move(normal)};
      parting.of_a.parts.push_back({half_space, half_spaces_.scale()});
      return proved(Verdict::apart, std::move(parting));
    }
    if (gap == Sign::negative) return std::nullopt;
    std::vector<Item> corners;
    for (const std::uint32_t k : face.indices) {
      if (corners.size() < MatrixGame::most) corners.push_back(point(k));
    }
    return inside(weights_within({{half_space, 1.0}}, corners));
  }

  // The weights of points, and of half-spaces, that are more than `least`.
  std::vector<Weights::Part> weights_of_points(double least) const {
    std::vector<Weights::Part> result;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      if (game_.column_weight(j) > least) result.push_back({columns_[j].index, game_.column_weight(j)});
    }
    return result;
  }
  std::vector<Weights::Part> weights_of_half_spaces(double least) const {
    std::vector<Weights::Part> result;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (game_.row_weight(i) > least) result.push_back({rows_[i].index, game_.row_weight(i)});
    }
    return result;
  }

  // Where the bodies only just touch, or do not, those that matter alone: points may be on the boundaries of the
  // half-spaces, exactly; where they are not, the exact weights of a point that is.
  std::optional<ExactDecision> tight() {
    if (rows_.empty() || columns_.empty()) return std::nullopt;
    std::vector<Weights::Part> points = weights_of_points(payoff_matters);
    const std::vector<Weights::Part> half_spaces = weights_of_half_spaces(payoff_matters);
    if (points.empty() || half_spaces.empty()) return std::nullopt;
    if (auto held = inside(points)) return held;
    if (auto held = parted(half_spaces)) return held;
    if (auto held = inside(weights_within(half_spaces, columns_at(half_spaces)))) return held;
    if (half_spaces.size() > most_dimension || points.size() > half_spaces.size() + 1) return std::nullopt;
    std::vector<ExactVector> payoffs;
    for (const Weights::Part& point : points) {
      const ExactVector image = points_.image(point.index);
      payoffs.emplace_back();
      for (const Weights::Part& of : half_spaces) {
        const ExactVector row = half_spaces_.half_space(of.index);
        payoffs.back().push_back(dot(row, image) - row[d_]);
      }
    }
    auto numbers = null_vector(payoffs);
    if (!numbers) return std::nullopt;
    for (std::size_t k = 0; k < points.size(); ++k) points[k].numerator = dyadic_of(std::move((*numbers)[k]), 0);
    return inside(points);
  }

  // Those points that are on the boundaries of all of these half-spaces, about.
  std::vector<Item> columns_at(const std::vector<Weights::Part>& half_spaces) const {
    std::vector<Item> columns = columns_;
    for (const Weights::Part& of : half_spaces) {
      const Item row{of.index, rounded_.row(of.index)};
      double greatest = 0;
      for (const Item& column : columns_) greatest = std::max(greatest, std::fabs(payoff(row, column)));
      std::erase_if(columns,
                    [&](const Item& column) { return std::fabs(payoff(row, column)) > greatest * about_zero; });
    }
    return columns;
  }

  // Weights of the points, at most MatrixGame::most, for a point that is as deep inside of all half-spaces but these as
  // may be: a game without these.
  std::vector<Weights::Part> weights_within(const std::vector<Weights::Part>& half_spaces,
                                            const std::vector<Item>& columns) const {
    std::vector<Item> rows;
    if (columns.empty()) return {};
    MatrixGame game;
    std::vector<Weights::Part> result;
    for (const Item& column : columns) {
      game.add_column([](std::size_t) { return 0.0; });
      result.push_back({column.index, 1.0});
    }
    CandidateRows candidates(half_spaces_.body());
    while (game.rows() < MatrixGame::most) {
      ColumnNumbers x{};
      double total = 0;
      for (std::size_t j = 0; j < columns.size(); ++j) {
        const double weight = rows.empty() ? 1 : game.column_weight(j);
        result[j].numerator = weight;
        total += weight;
        for (std::size_t c = 0; c < d_; ++c) x[c] += weight * columns[j].at[c];
      }
      const std::uint32_t broken = rounded_.most_broken(x, total, candidates, cost_).index;
      const bool is_boundary = std::any_of(half_spaces.begin(), half_spaces.end(),
                                           [&](const Weights::Part& of) { return of.index == broken; });
      if (is_boundary || has(rows, broken)) {
        if (candidates.are_all()) break;
        candidates.widen();
        continue;
      }
      rows.push_back({broken, rounded_.row(broken)});
      game.add_row([&](std::size_t j) { return payoff(rows.back(), columns[j]); });
      if (!game.solve()) break;
      if (candidates.are_all()) candidates.narrow();
    }
    return result;
  }

  std::optional<ExactDecision> inside(const std::vector<Weights::Part>& weights) {
    return met_by_weights(half_spaces_, points_, weights, cost_);
  }
  std::optional<ExactDecision> parted(const std::vector<Weights::Part>& weights) {
    return parted_by_weights(half_spaces_, points_, weights, cost_);
  }

  Placed half_spaces_, points_;
  RoundedHalfSpaces rounded_;
  std::size_t d_;
  Cost& cost_;
  std::vector<Item> rows_, columns_;
  MatrixGame game_;
};

}  // namespace

HalfSpaceProposal propose_by_game(const Polytope& half_spaces, const Pose& pose, const Polytope& points,
                                  const Pose& pose_of_points, Cost& cost) {
  return GameSearch(half_spaces, pose, points, pose_of_points, cost).propose();
}

}  // namespace sunder::polytope
