// The oracle: the simplex method on a full dictionary (oracle/dictionary_internal.h), by Bland's rule. Free variables are differences of
// two that are not negative; phase one has one artificial variable. It shares nothing with the front door.
#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/oracle/dictionary_internal.h>
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

// Variables 0 to d - 1 are the positive parts of coordinates, d to 2 d - 1 the negative ones, 2 d is artificial, then
// come the slacks of rows, each times a power of two.
class Program {
 public:
  Program(const Rows& rows, std::span<const Dyadic> objective)
      : d_(objective.size()), columns_(2 * d_ + 1), units_(rows.size()) {
    for (std::size_t k = 0; k < columns_; ++k) all_.others.push_back(static_cast<std::int64_t>(k));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      all_.basic.push_back(static_cast<std::int64_t>(columns_ + i));
      units_[i] = fill(all_.rows.emplace_back(columns_ + 1), rows[i], 1);
      std::swap(all_.rows[i][columns_], all_.rows[i][2 * d_]);
      all_.rows[i][2 * d_] = -1;
    }
    all_.objectives.assign(2, oracle::Integers(columns_ + 1));
    objective_unit_ = fill(all_.objectives[0], objective, -1);
    all_.objectives[1][2 * d_] = 1;  // minus the artificial variable
  }

  // Is there a point?
  bool find_point(Cost& cost) {
    std::size_t worst = 0;
    for (std::size_t i = 1; i < all_.rows.size(); ++i) {
      if (all_.rows[i].back() < all_.rows[worst].back()) worst = i;
    }
    if (!all_.rows.empty() && all_.rows[worst].back() < 0) {
      pivot(worst, 2 * d_, cost);
      climb(1, cost);
      if (all_.objectives[1].back() < 0) return false;
    }
    if (const auto row = all_.row_of(artificial())) {
      std::size_t j = 0;
      while (all_.rows[*row][j].is_zero()) ++j;
      pivot(*row, j, cost);
    }
    may_enter_artificial_ = false;
    return true;
  }

  // After that: is there a best one?
  bool find_best(Cost& cost) { return climb(0, cost); }

  ExactVector point() const {
    return coordinates([&](std::size_t i) { return all_.rows[i].back(); }, columns_);
  }
  // After find_best() denied it.
  ExactVector way() const {
    return coordinates([&](std::size_t i) { return -all_.rows[i][along_]; }, along_);
  }
  Dyadic denominator() const { return dyadic_of(all_.denominator, 0); }

  // Of rows, over the denominator: of the best point, or of what contradicts.
  std::vector<Weights::Part> multipliers(bool of_best) const {
    std::vector<Weights::Part> result;
    for (std::size_t j = 0; j < columns_; ++j) {
      const Integer& y = all_.objectives[of_best ? 0 : 1][j];
      if (all_.others[j] <= artificial() || y.is_zero()) continue;
      const auto i = static_cast<std::size_t>(all_.others[j]) - columns_;
      result.push_back({static_cast<std::uint32_t>(i), dyadic_of(y, (of_best ? objective_unit_ : 0) - units_[i])});
    }
    return result;
  }

 private:
  std::int64_t artificial() const { return static_cast<std::int64_t>(2 * d_); }

  // Coefficients of coordinates times the sign; what stands behind them comes into column 2 d. Returns the unit.
  std::int64_t fill(oracle::Integers& to, std::span<const Dyadic> numbers, int sign) const {
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
    const auto add = [&](std::int64_t variable, const Integer& value) {
      if (variable >= artificial() || value.is_zero()) return;
      const auto k = static_cast<std::size_t>(variable);
      x[k % d_] = k < d_ ? x[k % d_] + dyadic_of(value, 0) : x[k % d_] - dyadic_of(value, 0);
    };
    for (std::size_t i = 0; i < all_.rows.size(); ++i) add(all_.basic[i], value_of(i));
    if (other < columns_) add(all_.others[other], all_.denominator);
    return x;
  }

  // Of this objective: is there a greatest value?
  bool climb(std::size_t z, Cost& cost) {
    const auto may_enter = [&](std::int64_t variable) { return variable != artificial() || may_enter_artificial_; };
    while (const auto c = all_.entering(all_.objectives[z], may_enter)) {
      may_be_interrupted(1000);
      const auto r = all_.leaving(*c);
      if (!r) {
        along_ = *c;
        return false;
      }
      pivot(*r, *c, cost);
    }
    return true;
  }

  void pivot(std::size_t r, std::size_t c, Cost& cost) {
    ++cost.iterations;
    cost.probes += all_.rows.size();
    all_.pivot(r, c);
  }

  std::size_t d_, columns_;
  std::vector<std::int64_t> units_;
  std::int64_t objective_unit_ = 0;
  oracle::Dictionary all_;
  bool may_enter_artificial_ = true;
  std::size_t along_ = 0;
};

// Are other points as good as the best one? Then such a one; else multipliers that say that there are none.
ProgramEvidence decide_uniqueness(Rows rows, std::span<const double> objective, OneOptimum best, Cost& cost) {
  const std::size_t d = objective.size();
  const ExactPointN& point = best.point;
  const auto own = static_cast<std::uint32_t>(rows.size());
  ExactVector as_good;  // objective . x >= its greatest value
  for (const double c : objective) as_good.push_back(-(Dyadic(c) * point.denominator));
  as_good.push_back(-dot(point.numbers, objective));
  rows.push_back(std::move(as_good));
  Weights total = best.multipliers;
  const auto add = [&](std::uint32_t row, const Dyadic& numerator) {
    const auto found = std::find_if(total.parts.begin(), total.parts.end(),
                                    [&](const Weights::Part& part) { return part.index == row; });
    Weights::Part& part = found != total.parts.end() ? *found : total.parts.emplace_back(row, Dyadic());
    part.numerator = part.numerator + numerator;
  };
  for (std::size_t c = 0; c < d; ++c) {
    std::array<Weights, 2> sides;
    for (const std::size_t side : {0u, 1u}) {
      ExactVector along(d);
      along[c] = side == 0 ? 1.0 : -1.0;
      Program program(rows, along);
      program.find_point(cost);
      const bool is_bounded = program.find_best(cost);
      ExactPointN other = is_bounded ? ExactPointN{program.point(), program.denominator()} : point;
      if (!is_bounded) {
        const ExactVector way = program.way();
        for (std::size_t k = 0; k < d; ++k) other.numbers[k] = other.numbers[k] + way[k];
      }
      if (!is_bounded || !(other.numbers[c] * point.denominator == point.numbers[c] * other.denominator)) {
        return ManyOptima{std::move(best.point), std::move(other), std::move(best.multipliers)};
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
          total.denominator = total.denominator + by * point.denominator;
        }
      }
    }
  }
  best.multipliers = std::move(total);
  return best;
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
  LinearProgramAnswer answer{{}, DecidedBy::scan, {.exact = 1}};
  Program program(rows, exact);
  if (!program.find_point(answer.cost)) {
    answer.evidence = NoPoint{{program.multipliers(false), program.denominator()}};
    return answer;
  }
  const bool is_bounded = program.find_best(answer.cost);
  ExactPointN point{program.point(), program.denominator()};
  if (std::all_of(objective.begin(), objective.end(), [](double x) { return x == 0; })) {
    answer.evidence = AnyPoint{std::move(point)};
  } else if (!is_bounded) {
    answer.evidence = NoBound{std::move(point), program.way()};
  } else {
    OneOptimum best{std::move(point), {program.multipliers(true), program.denominator()}};
    answer.evidence = decide_uniqueness(std::move(rows), objective, std::move(best), answer.cost);
  }
  return answer;
}

}  // namespace sunder::polytope
