// The oracle: the simplex method on a full dictionary in integers, by Bland's rule. Free variables are differences of
// two that are not negative; phase one has one artificial variable. It shares nothing with the front door.
#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/number/integer_internal.h>
#include <sunder/polytope/pair/placed.h>
#include <sunder/polytope/region/linear_program.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

using Rows = std::vector<ExactVector>;  // a1, .., ad, b

// Basic variables in terms of the others: basic_i = (T[i][n] - sum T[i][j] other_j) / D. Variables 0 to d - 1 are the
// positive parts of coordinates, d to 2 d - 1 the negative ones, 2 d is artificial, then come the slacks of rows, each
// times a power of two.
class Dictionary {
 public:
  Dictionary(const Rows& rows, std::span<const Dyadic> objective)
      : d_(objective.size()), columns_(2 * d_ + 1), size_(rows.size()), units_(rows.size()) {
    table_.assign(size_ + 2, std::vector<Integer>(columns_ + 1));
    for (std::size_t k = 0; k < columns_; ++k) others_.push_back(k);
    for (std::size_t i = 0; i < size_; ++i) {
      basic_.push_back(columns_ + i);
      units_[i] = fill(table_[i], rows[i], 1);
      std::swap(table_[i][columns_], table_[i][2 * d_]);
      table_[i][2 * d_] = -1;
    }
    objective_unit_ = fill(table_[size_], objective, -1);
    table_[size_ + 1][2 * d_] = 1;
  }

  // Is there a point?
  bool find_point(Cost& cost) {
    std::size_t worst = size_;
    for (std::size_t i = 0; i < size_; ++i) {
      if (table_[i][columns_] < 0 && (worst == size_ || table_[i][columns_] < table_[worst][columns_])) worst = i;
    }
    if (worst < size_) {
      pivot(worst, 2 * d_, cost);
      climb(size_ + 1, cost);
      if (table_[size_ + 1][columns_] < 0) return false;
    }
    const auto artificial = std::find(basic_.begin(), basic_.end(), 2 * d_);
    if (artificial != basic_.end()) {
      const auto i = static_cast<std::size_t>(artificial - basic_.begin());
      std::size_t j = 0;
      while (table_[i][j].is_zero()) ++j;
      pivot(i, j, cost);
    }
    may_enter_artificial_ = false;
    return true;
  }

  // After that: is there a best one?
  bool find_best(Cost& cost) { return climb(size_, cost); }

  ExactVector point() const {
    return coordinates([&](std::size_t i) { return table_[i][columns_]; }, columns_);
  }
  // After find_best() denied it.
  ExactVector way() const {
    return coordinates([&](std::size_t i) { return -table_[i][along_]; }, along_);
  }
  Dyadic denominator() const { return dyadic_of(determinant_, 0); }

  // Of rows, over the denominator: of the best point, or of what contradicts.
  std::vector<Weights::Part> multipliers(bool of_best) const {
    std::vector<Weights::Part> result;
    for (std::size_t j = 0; j < columns_; ++j) {
      const Integer& y = table_[size_ + (of_best ? 0 : 1)][j];
      if (others_[j] <= 2 * d_ || y.is_zero()) continue;
      const std::size_t i = others_[j] - columns_;
      result.push_back({static_cast<std::uint32_t>(i), dyadic_of(y, (of_best ? objective_unit_ : 0) - units_[i])});
    }
    return result;
  }

 private:
  // Coefficients of coordinates times the sign; what stands behind them comes into column 2 d. Returns the unit.
  std::int64_t fill(std::vector<Integer>& to, std::span<const Dyadic> numbers, int sign) const {
    std::int64_t unit = std::numeric_limits<std::int64_t>::max();
    for (const Dyadic& x : numbers) {
      if (x.sign() != Sign::zero) unit = std::min(unit, x.exponent());
    }
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (numbers[k].sign() == Sign::zero) continue;
      const Integer n = mantissa_of(numbers[k]) << static_cast<unsigned>(numbers[k].exponent() - unit);
      to[k < d_ ? k : 2 * d_] = n * sign;
      if (k < d_) to[d_ + k] = n * -sign;
    }
    return unit == std::numeric_limits<std::int64_t>::max() ? 0 : unit;
  }

  template <class Value>
  ExactVector coordinates(const Value& value_of, std::size_t other) const {
    ExactVector x(d_);
    const auto add = [&](std::size_t variable, const Integer& value) {
      if (variable >= 2 * d_ || value.is_zero()) return;
      const std::size_t c = variable % d_;
      x[c] = variable < d_ ? x[c] + dyadic_of(value, 0) : x[c] - dyadic_of(value, 0);
    };
    for (std::size_t i = 0; i < size_; ++i) add(basic_[i], value_of(i));
    if (other < columns_) add(others_[other], determinant_);
    return x;
  }

  bool climb(std::size_t z, Cost& cost) {
    for (;;) {
      may_be_interrupted(1000);
      std::size_t c = columns_;
      for (std::size_t j = 0; j < columns_; ++j) {
        const bool may_enter = others_[j] != 2 * d_ || may_enter_artificial_;
        if (may_enter && table_[z][j] < 0 && (c == columns_ || others_[j] < others_[c])) c = j;
      }
      if (c == columns_) return true;
      std::size_t r = size_;
      for (std::size_t i = 0; i < size_; ++i) {
        if (table_[i][c] <= 0) continue;
        if (r == size_) {
          r = i;
          continue;
        }
        const int order = (table_[i][columns_] * table_[r][c]).compare(table_[r][columns_] * table_[i][c]);
        if (order < 0 || (order == 0 && basic_[i] < basic_[r])) r = i;
      }
      if (r == size_) {
        along_ = c;
        return false;
      }
      pivot(r, c, cost);
    }
  }

  void pivot(std::size_t r, std::size_t c, Cost& cost) {
    ++cost.iterations;
    cost.probes += size_;
    const Integer by = table_[r][c];
    const bool is_negative = by < 0;
    for (std::size_t i = 0; i < table_.size(); ++i) {
      if (i == r) continue;
      const Integer factor = table_[i][c];
      for (std::size_t j = 0; j <= columns_; ++j) {
        if (j == c) continue;
        Integer& x = table_[i][j];
        if (x.is_zero() && factor.is_zero()) continue;
        x = (x * by - factor * table_[r][j]) / determinant_;  // exact
        if (is_negative) x = -x;
      }
      table_[i][c] = is_negative ? factor : -factor;
    }
    if (is_negative) {
      for (Integer& x : table_[r]) x = -x;
    }
    table_[r][c] = is_negative ? -determinant_ : determinant_;
    determinant_ = is_negative ? -by : by;
    std::swap(basic_[r], others_[c]);
  }

  std::size_t d_, columns_, size_;
  std::vector<std::int64_t> units_;
  std::int64_t objective_unit_ = 0;
  std::vector<std::vector<Integer>> table_;  // rows; then the objective; then minus the artificial variable
  std::vector<std::size_t> basic_, others_;
  Integer determinant_ = 1;
  bool may_enter_artificial_ = true;
  std::size_t along_ = 0;
};

// Are other points as good as the best one? Then `other`; else multipliers that say so.
void decide_uniqueness(Rows rows, std::span<const double> objective, LinearProgramAnswer& answer) {
  const std::size_t d = objective.size();
  const auto own = static_cast<std::uint32_t>(rows.size());
  ExactVector as_good;  // objective . x >= its greatest value
  for (const double c : objective) as_good.push_back(-(Dyadic(c) * answer.point.denominator));
  as_good.push_back(-dot(answer.point.numbers, objective));
  rows.push_back(std::move(as_good));
  Weights total = answer.multipliers;
  const auto add = [&](std::uint32_t row, const Dyadic& numerator) {
    const auto found = std::find_if(total.parts.begin(), total.parts.end(),
                                    [&](const Weights::Part& part) { return part.index == row; });
    Weights::Part& part = found != total.parts.end() ? *found : total.parts.emplace_back(row, Dyadic());
    part.numerator = part.numerator + numerator;
  };
  answer.outcome = Optimum::many;
  for (std::size_t c = 0; c < d; ++c) {
    std::array<Weights, 2> sides;
    for (const std::size_t side : {0u, 1u}) {
      ExactVector along(d);
      along[c] = side == 0 ? 1.0 : -1.0;
      Dictionary program(rows, along);
      program.find_point(answer.cost);
      const bool is_bounded = program.find_best(answer.cost);
      answer.other = {program.point(), program.denominator()};
      if (!is_bounded) {
        const ExactVector way = program.way();
        answer.other = answer.point;
        for (std::size_t k = 0; k < d; ++k) answer.other.numbers[k] = answer.other.numbers[k] + way[k];
        return;
      }
      if (!(answer.other.numbers[c] * answer.point.denominator == answer.point.numbers[c] * answer.other.denominator)) {
        return;
      }
      sides[side] = {program.multipliers(true), program.denominator()};
    }
    // Their sum is zero, but for the row of the objective, whose multiplier is one of the objective's on the other
    // side.
    for (const std::size_t side : {0u, 1u}) {
      for (const auto& [row, numerator] : sides[side].parts) {
        const Dyadic by = numerator * sides[1 - side].denominator;
        if (row < own) {
          add(row, by);
        } else {
          total.denominator = total.denominator + by * answer.point.denominator;
        }
      }
    }
  }
  answer.outcome = Optimum::one;
  answer.other = {};
  answer.multipliers = std::move(total);
}

}  // namespace

LinearProgramAnswer linear_program_by_scan(const Polytope& half_spaces, std::span<const double> objective) {
  SUNDER_REQUIRE(!half_spaces.is_of_points() && objective.size() == half_spaces.dimension());
  Rows rows;
  for (std::uint32_t k = 0; k < half_spaces.size(); ++k) {
    const std::span<const double> row = half_spaces.row(k);
    rows.emplace_back(row.begin(), row.end());
  }
  const ExactVector exact(objective.begin(), objective.end());
  LinearProgramAnswer answer;
  answer.decided_by = DecidedBy::scan;
  answer.cost.exact = 1;
  Dictionary program(rows, exact);
  if (!program.find_point(answer.cost)) {
    answer.multipliers = {program.multipliers(false), program.denominator()};
    return answer;
  }
  const bool is_bounded = program.find_best(answer.cost);
  answer.point = {program.point(), program.denominator()};
  if (std::all_of(objective.begin(), objective.end(), [](double x) { return x == 0; })) {
    answer.outcome = Optimum::all;
  } else if (!is_bounded) {
    answer.outcome = Optimum::unbounded;
    answer.direction = program.way();
  } else {
    answer.multipliers = {program.multipliers(true), program.denominator()};
    decide_uniqueness(std::move(rows), objective, answer);
  }
  return answer;
}

}  // namespace sunder::polytope
