#include <sunder/base/contract.h>
#include <sunder/polytope/region/program_outcome_internal.h>
#include <sunder/polytope/region/program_search_internal.h>

#include <algorithm>
#include <utility>

namespace sunder::polytope {

namespace {

ExactVector doubles_of(std::span<const double> numbers) { return {numbers.begin(), numbers.end()}; }

// point + way / 2^k: the first k from `from` on that leaves no half-space. Requires that some does.
ExactPointN moved(const Polytope& body, const ExactPointN& point, const ExactVector& way, Cost& cost) {
  const std::size_t d = body.dimension();
  for (std::int64_t power = 0;;) {
    ExactVector direction(d + 1);
    for (std::size_t j = 0; j < d; ++j) direction[j] = point.numbers[j] + way[j].scaled(power);
    direction[d] = -point.denominator;
    cost.probes += body.size();
    if (body.size() == 0 ||
        exactly_furthest_along(body.columns(), direction, cost.exact).product.sign() != Sign::positive) {
      direction.pop_back();
      return {std::move(direction), point.denominator};
    }
    power = power == 0 ? -1 : 2 * power;
  }
}

// Where all rows of a basis are given, and some have no weight: are other points as good? The best points near the
// point p are p + r, where a . r <= 0 for rows a that hold p, = 0 for those of the basis that have a weight. A row of
// the basis that has none is left by each r that is not zero, so we maximize minus the sum of those: that is unbounded,
// or zero, and then its multipliers, times e, and those rows themselves, times e, may be added to the weights.
ProgramEvidence decide_uniqueness(const Polytope& body, const std::vector<DualSimplex::BasisRow>& basis,
                                  const Dyadic& one, ExactPointN point, Weights weights, Cost& cost) {
  const std::size_t d = body.dimension();
  ExactVector at = point.numbers;
  at.push_back(-point.denominator);
  cost.probes += body.size();
  std::vector<std::uint32_t> rows = at_zero_along(body.columns(), at, cost.exact);
  std::vector<double> cone;
  const auto add = [&](std::uint32_t k, double sign) {
    const std::span<const double> row = body.row(k);
    for (std::size_t c = 0; c < d; ++c) cone.push_back(sign * row[c]);
    cone.push_back(0);
  };
  for (const std::uint32_t k : rows) add(k, 1);
  const std::size_t tight = rows.size();
  ExactVector away(d);
  for (const auto& [row, weight] : basis) {
    if (weight.sign() != Sign::zero) {
      add(row, -1);
      rows.push_back(row);
    } else {
      for (std::size_t c = 0; c < d; ++c) away[c] = away[c] - Dyadic(body.row(row)[c]);
    }
  }
  const Polytope around = Polytope::from_half_spaces(d, std::move(cone));
  DualSimplex program(around, away);
  program.solve(cost);
  if (program.is_unbounded()) {
    ExactPointN other = moved(body, point, program.way(), cost);
    return ManyOptima{std::move(point), std::move(other), std::move(weights)};
  }
  // Of basis rows the weights are n / one, the multipliers m / other_one. The sum of both, times e = 1 / 2^k.
  const Dyadic other_one = program.denominator();
  struct Sum {
    Dyadic weight, added;  // over one other_one
  };
  std::vector<std::pair<std::uint32_t, Sum>> sums;
  const auto sum_of = [&](std::uint32_t row) -> Sum& {
    const auto found = std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == row; });
    return found != sums.end() ? found->second : sums.emplace_back(row, Sum{}).second;
  };
  for (const auto& [row, weight] : basis) {
    sum_of(row).weight = weight * other_one;
    if (weight.sign() == Sign::zero) sum_of(row).added = one * other_one;
  }
  for (const auto& [k, weight] : program.basis()) {
    if (k >= first_box_side) continue;  // of weight zero
    Dyadic& added = sum_of(rows[k]).added;
    const Dyadic by = weight * one;
    added = k < tight ? added + by : added - by;
  }
  // At once: small enough for all.
  std::int64_t power = 0;
  const auto is_too_great = [&](const auto& sum) {
    return sum.second.weight.sign() == Sign::positive &&
           (sum.second.weight + sum.second.added.scaled(power)).sign() != Sign::positive;
  };
  while (std::any_of(sums.begin(), sums.end(), is_too_great)) power = power == 0 ? -1 : 2 * power;
  OneOptimum best{std::move(point), {{}, one * other_one}};
  for (const auto& [row, sum] : sums) {
    Dyadic total = sum.weight + sum.added.scaled(power);
    if (total.sign() != Sign::zero) best.multipliers.parts.push_back({row, std::move(total)});
  }
  return best;
}

// The evidence of a program that has been solved.
ProgramEvidence evidence_of(const DualSimplex& program, const Polytope& half_spaces, std::span<const Dyadic> objective,
                            Cost& cost) {
  ExactPointN point = program.point();
  const bool has_objective =
      std::any_of(objective.begin(), objective.end(), [](const Dyadic& x) { return x.sign() != Sign::zero; });
  if (!has_objective) return AnyPoint{std::move(point)};
  if (program.is_unbounded()) return NoBound{std::move(point), program.way()};
  const std::vector<DualSimplex::BasisRow> rows = program.basis();
  Weights weights{{}, program.denominator()};
  for (const auto& [row, weight] : rows) {
    if (weight.sign() != Sign::zero) weights.parts.push_back({row, weight});
  }
  if (program.is_at_box()) {
    ExactPointN other = point;
    for (std::size_t j = 0; j < objective.size(); ++j) other.numbers[j] = other.numbers[j] + program.way()[j];
    return ManyOptima{std::move(point), std::move(other), std::move(weights)};
  }
  if (weights.parts.size() == rows.size()) return OneOptimum{std::move(point), std::move(weights)};
  return decide_uniqueness(half_spaces, rows, program.denominator(), std::move(point), std::move(weights), cost);
}

}  // namespace

RowBasis basis_of_box(std::size_t dimension) {
  RowBasis basis;
  for (std::size_t j = 0; j < dimension; ++j) basis.rows[j] = first_box_side + static_cast<std::uint32_t>(j);
  return basis;
}

LinearProgramAnswer decide_from(const Polytope& half_spaces, std::span<const Dyadic> objective, const RowBasis& basis) {
  SUNDER_REQUIRE(!half_spaces.is_of_points() && objective.size() == half_spaces.dimension());
  DualSimplex program(half_spaces, objective);
  program.begin_at(basis);
  LinearProgramAnswer answer;
  answer.cost.probes = basis.proposal_probes;
  answer.cost.iterations = basis.steps;
  answer.cost.proposals = 1;
  const bool is_feasible = program.solve(answer.cost);
  answer.decided_by = program.pivots() > 0 ? DecidedBy::finishing : DecidedBy::evidence;
  if (is_feasible) {
    answer.evidence = evidence_of(program, half_spaces, objective, answer.cost);
  } else {
    answer.evidence = NoPoint{program.contradiction()};
  }
  return answer;
}

LinearProgramAnswer linear_program(const Polytope& half_spaces, std::span<const double> objective) {
  SUNDER_REQUIRE(!half_spaces.is_of_points() && objective.size() == half_spaces.dimension());
  return decide_from(half_spaces, doubles_of(objective), basis_by_scans(half_spaces, objective));
}

LinearProgramAnswer linear_program_by_seidel(const Polytope& half_spaces, std::span<const double> objective) {
  SUNDER_REQUIRE(!half_spaces.is_of_points() && objective.size() == half_spaces.dimension());
  return decide_from(half_spaces, doubles_of(objective), basis_by_seidel(half_spaces, objective));
}

}  // namespace sunder::polytope
