#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/phase_one_internal.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

enum Kind : std::uint32_t { kind_a = 0, kind_b = 1, slack = 2 };

// Of trees: are there levels below those that were looked at? Then both go down one.
bool deepened(Placed& a, Placed& b) {
  const bool of_first = a.deepen(), of_second = b.deepen();
  return of_first || of_second;
}

// The weights of A's variables and of B's; and as numbers the sum of those of one kind times its vectors.
template <class VectorOf>
ExactEvidence weighted(const PhaseOne& program, std::size_t d, Kind summed, const VectorOf& vector_of) {
  ExactEvidence result{.numbers = ExactVector(d)};
  for (const auto& [variable, weight] : program.weights()) {
    if (variable.kind == slack) continue;
    (variable.kind == kind_a ? result.of_a : result.of_b).parts.push_back({variable.index, weight});
    if (variable.kind == summed) add_multiple(result.numbers, weight, vector_of(variable.index));
  }
  return result;
}

// ---- Points and points.

struct NamedColumn {
  BasicVariable variable;
  ExactVector numbers;
};

class PointsProgram {
 public:
  PointsProgram(Placed& a, Placed& b) : a_(a), b_(b), d_(a.dimension()), program_(d_ + 2, 2) {}

  ExactVector column(Kind kind, std::uint32_t k) const {
    ExactVector column = kind == kind_a ? a_.image(k) : negated(b_.image(k));
    column.emplace_back(kind == kind_a ? 1.0 : 0.0);
    column.emplace_back(kind == kind_b ? 1.0 : 0.0);
    return column;
  }

  bool enter_if_it_pays(Kind kind, std::uint32_t k) { return program_.enter_if_it_pays({kind, k}, column(kind, k)); }

  // Those named, until they are a solution or none pays.
  bool try_named(std::span<const std::uint32_t> named_a, std::span<const std::uint32_t> named_b) {
    std::vector<NamedColumn> columns;
    for (const std::uint32_t k : named_a) columns.push_back({{kind_a, k}, column(kind_a, k)});
    for (const std::uint32_t k : named_b) columns.push_back({{kind_b, k}, column(kind_b, k)});
    return enter_all(columns);
  }

  bool enter_all(const std::vector<NamedColumn>& columns) {
    for (bool pays = true; pays && !program_.is_solved();) {
      pays = false;
      for (const auto& [variable, exact] : columns) {
        if (program_.enter_if_it_pays(variable, exact)) pays = true;
        if (program_.is_solved()) return true;
      }
    }
    return program_.is_solved();
  }

  // False where the bodies are apart; nothing after `most` steps.
  std::optional<bool> solve(Cost& cost, std::uint32_t most = std::numeric_limits<std::uint32_t>::max()) {
    for (std::uint32_t step = 0; !program_.is_solved(); ++step) {
      may_be_interrupted(1000);
      if (step > most) return std::nullopt;
      const ExactVector y = program_.multipliers();
      const ExactFurthest from_a = a_.furthest(y, cost), from_b = b_.furthest(negated(y), cost);
      ++cost.iterations;
      const bool a_pays = enter_if_it_pays(kind_a, from_a.index), b_pays = enter_if_it_pays(kind_b, from_b.index);
      if (!a_pays && !b_pays && !deepened(a_, b_)) return false;
    }
    return true;
  }

  ExactEvidence parting() const {
    ExactVector y = program_.multipliers();
    y.resize(d_);
    return {.numbers = std::move(y)};
  }

  ExactEvidence common_point() const {
    ExactEvidence result = weighted(program_, d_, kind_a, [&](std::uint32_t k) { return a_.image(k); });
    result.denominator = result.of_a.denominator = result.of_b.denominator = program_.denominator();
    return result;
  }

 private:
  Placed &a_, &b_;
  std::size_t d_;
  PhaseOne program_;
};

// ---- Half-spaces and half-spaces.

ExactDecision decide_half_spaces(Placed& a, Placed& b, std::span<const std::uint32_t> named_a,
                                 std::span<const std::uint32_t> named_b, Cost& cost) {
  const std::size_t d = a.dimension();
  PhaseOne program(d + 1, 1);
  const auto column_of = [&](Kind kind, std::uint32_t k) {
    ExactVector column = (kind == kind_a ? a : b).half_space(k);
    column[d] = -column[d];
    return column;
  };
  for (bool pays = true; pays && !program.is_solved();) {
    pays = false;
    for (const std::uint32_t k : named_a) pays = program.enter_if_it_pays({kind_a, k}, column_of(kind_a, k)) || pays;
    for (const std::uint32_t k : named_b) pays = program.enter_if_it_pays({kind_b, k}, column_of(kind_b, k)) || pays;
  }
  while (!program.is_solved()) {
    may_be_interrupted(1000);
    const ExactVector y = program.multipliers();
    const std::span<const Dyadic> place(y.data(), d);
    bool pays = false;
    for (const Kind kind : {kind_a, kind_b}) {
      Placed& body = kind == kind_a ? a : b;
      const auto broken = body.most_broken(place, y[d], cost);
      if (broken) pays = program.enter_if_it_pays({kind, broken->index}, column_of(kind, broken->index)) || pays;
    }
    ++cost.iterations;
    if (pays || deepened(a, b)) continue;
    ExactEvidence common{.numbers = {place.begin(), place.end()}, .denominator = y[d]};
    common.in_a = a.in_frame(place, y[d]);
    common.in_b = b.in_frame(place, y[d]);
    return proved(Verdict::meet, std::move(common));
  }
  ExactEvidence parting = weighted(program, d, kind_a, [&](std::uint32_t k) { return a.half_space(k); });
  for (Weights::Part& part : parting.of_a.parts) part.numerator = part.numerator * a.scale();
  for (Weights::Part& part : parting.of_b.parts) part.numerator = part.numerator * b.scale();
  return proved(Verdict::apart, std::move(parting));
}

// ---- Half-spaces and points.

// Some half-spaces with all points.
class MixedProgram {
 public:
  MixedProgram(Placed& half_spaces, Placed& points, std::span<const std::uint32_t> some)
      : half_spaces_(half_spaces), points_(points), d_(points.dimension()), some_(some), program_(some.size() + 1, 1) {
    for (const std::uint32_t k : some) rows_.push_back(half_spaces.half_space(k));
  }

  bool enter_if_it_pays(std::uint32_t point) {
    const ExactVector p = points_.image(point);
    ExactVector column;
    for (const ExactVector& row : rows_) column.push_back(dot(row, p) - row[d_]);
    column.emplace_back(1.0);
    return program_.enter_if_it_pays({kind_b, point}, column);
  }

  bool solve(std::span<const std::uint32_t> named, Cost& cost) {
    for (const std::uint32_t k : named) enter_if_it_pays(k);
    while (!program_.is_solved()) {
      may_be_interrupted(1000);
      bool pays = false;
      for (std::uint32_t i = 0; i < rows_.size(); ++i) {
        ExactVector column(rows_.size() + 1);
        column[i] = 1.0;
        pays = program_.enter_if_it_pays({slack, i}, column) || pays;
      }
      const ExactVector direction = combined(program_.multipliers());
      const ExactFurthest furthest = points_.furthest(direction, cost);
      ++cost.iterations;
      if (!enter_if_it_pays(furthest.index) && !pays && !points_.deepen()) return false;
    }
    return true;
  }

  // The combination of normals by these numbers.
  ExactVector combined(std::span<const Dyadic> by) const {
    ExactVector sum(d_);
    for (std::size_t i = 0; i < rows_.size(); ++i) add_multiple(sum, by[i], rows_[i]);
    return sum;
  }

  // No half-space is further along the direction than the points are.
  ExactEvidence parting() const {
    const ExactVector y = negated(program_.multipliers());  // of the half-spaces not negative
    ExactEvidence result{.numbers = combined(y)};
    for (std::size_t i = 0; i < some_.size(); ++i) {
      if (y[i].sign() != Sign::zero) result.of_a.parts.push_back({some_[i], y[i] * half_spaces_.scale()});
    }
    return result;
  }

  ExactEvidence common_point() const {
    ExactEvidence result = weighted(program_, d_, kind_b, [&](std::uint32_t k) { return points_.image(k); });
    result.denominator = result.of_b.denominator = program_.denominator();
    return result;
  }

 private:
  Placed& half_spaces_;
  Placed& points_;
  std::size_t d_;
  std::span<const std::uint32_t> some_;
  PhaseOne program_;
  std::vector<ExactVector> rows_;
};

// A of half-spaces, B of points.
ExactDecision decide_mixed(Placed& a, Placed& b, std::span<const std::uint32_t> named_a,
                           std::span<const std::uint32_t> named_b, Cost& cost) {
  std::vector<std::uint32_t> some(named_a.begin(), named_a.end()), named(named_b.begin(), named_b.end());
  for (;;) {
    may_be_interrupted(1000);
    MixedProgram program(a, b, some);
    if (!program.solve(named, cost)) return proved(Verdict::apart, program.parting());
    ExactEvidence common = program.common_point();
    auto broken = a.most_broken(common.numbers, common.denominator, cost);
    while (broken && broken->product.sign() != Sign::positive && a.deepen()) {
      broken = a.most_broken(common.numbers, common.denominator, cost);
    }
    if (!broken || broken->product.sign() != Sign::positive) {
      common.in_a = a.in_frame(common.numbers, common.denominator);
      return proved(Verdict::meet, std::move(common));
    }
    some.push_back(broken->index);
    named.clear();
    for (const Weights::Part& part : common.of_b.parts) named.push_back(part.index);
  }
}

}  // namespace

ExactDecision exchanged(ExactDecision decision) {
  ExactEvidence evidence = *decision.evidence;
  if (decision.verdict == Verdict::apart) evidence.numbers = negated(std::move(evidence.numbers));
  std::swap(evidence.of_a, evidence.of_b);
  std::swap(evidence.in_a, evidence.in_b);
  return proved(decision.verdict, std::move(evidence));
}

namespace {

ExactDecision decide(Placed& a, Placed& b, std::span<const std::uint32_t> named_a,
                     std::span<const std::uint32_t> named_b, Cost& cost) {
  ++cost.exact;
  const bool points_a = a.body().is_of_points(), points_b = b.body().is_of_points();
  if (!points_a && !points_b) return decide_half_spaces(a, b, named_a, named_b, cost);
  if (!points_a) return decide_mixed(a, b, named_a, named_b, cost);
  if (!points_b) return exchanged(decide_mixed(b, a, named_b, named_a, cost));
  PointsProgram program(a, b);
  const bool meet = program.try_named(named_a, named_b) || *program.solve(cost);
  return meet ? proved(Verdict::meet, program.common_point()) : proved(Verdict::apart, program.parting());
}

}  // namespace

ExactDecision decide_exactly(Placed a, Placed b, std::span<const std::uint32_t> named_a,
                             std::span<const std::uint32_t> named_b, Cost& cost, std::uint32_t* tree_scans) {
  ExactDecision decision = decide(a, b, named_a, named_b, cost);
  if (tree_scans != nullptr) *tree_scans += a.scans() + b.scans();
  return decision;
}

std::optional<ExactDecision> decide_by_few(Placed& a, Placed& b, std::span<const std::uint32_t> named_a,
                                           std::span<const std::uint32_t> named_b, std::uint32_t most, Cost& cost) {
  PointsProgram program(a, b);
  Cost own;
  const std::optional<bool> meet = program.try_named(named_a, named_b) ? std::optional(true) : program.solve(own, most);
  cost.probes += own.probes;
  cost.exact += own.exact + 1;
  cost.proposals += own.iterations;
  if (!meet) return std::nullopt;
  return *meet ? proved(Verdict::meet, program.common_point()) : proved(Verdict::apart, program.parting());
}

ExactEvidence common_point_of(Placed a, Placed b, std::span<const std::uint32_t> named_a,
                              std::span<const std::uint32_t> named_b) {
  PointsProgram program(a, b);
  [[maybe_unused]] const bool found = program.try_named(named_a, named_b);
  SUNDER_REQUIRE(found);
  return program.common_point();
}

}  // namespace sunder::polytope
