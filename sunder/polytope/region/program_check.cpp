#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/region/linear_program.h>
#include <sunder/polytope/region/rows_check_internal.h>

#include <algorithm>

namespace sunder::polytope {

std::string_view name_of(Optimum optimum) {
  switch (optimum) {
    case Optimum::one: return "one";
    case Optimum::many: return "many";
    case Optimum::all: return "all";
    case Optimum::unbounded: return "unbounded";
    case Optimum::infeasible: return "infeasible";
  }
  return "";
}

bool keeps(const Polytope& body, const ExactPointN& point) {
  const std::size_t d = body.dimension();
  if (point.numbers.size() != d || point.denominator.sign() != Sign::positive) return false;
  for (std::uint32_t k = 0; k < body.size(); ++k) {
    const std::span<const double> row = body.row(k);
    if ((dot(point.numbers, row.first(d)) - point.denominator * Dyadic(row[d])).sign() == Sign::positive) return false;
  }
  return true;
}

bool recedes(const Polytope& body, std::span<const Dyadic> direction) {
  const std::size_t d = body.dimension();
  if (direction.size() != d) return false;
  for (std::uint32_t k = 0; k < body.size(); ++k) {
    if (dot(direction, body.row(k).first(d)).sign() == Sign::positive) return false;
  }
  return std::any_of(direction.begin(), direction.end(), [](const Dyadic& x) { return x.sign() != Sign::zero; });
}

std::optional<SumOfRows> sum_of(const Polytope& body, const Weights& multipliers) {
  const std::size_t d = body.dimension();
  SumOfRows result{ExactVector(d + 1), 0};
  Elimination span(d);
  if (multipliers.denominator.sign() != Sign::positive) return std::nullopt;
  for (const auto& [row, weight] : multipliers.parts) {
    if (row >= body.size() || weight.sign() != Sign::positive) return std::nullopt;
    const std::span<const double> numbers = body.row(row);
    for (std::size_t c = 0; c <= d; ++c) result.row[c] = result.row[c] + weight * Dyadic(numbers[c]);
    span.add(ExactVector(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(d)));
  }
  result.rank = span.rank();
  return result;
}

bool contradicts(const Polytope& body, const Weights& multipliers) {
  const auto sum = sum_of(body, multipliers);
  const std::size_t d = body.dimension();
  return sum && sum->row[d].sign() == Sign::negative &&
         std::all_of(sum->row.begin(), sum->row.end() - 1, [](const Dyadic& x) { return x.sign() == Sign::zero; });
}

bool check(const Polytope& half_spaces, std::span<const double> objective, const LinearProgramAnswer& answer) {
  const std::size_t d = half_spaces.dimension();
  if (!answer.feasible()) return contradicts(half_spaces, answer.multipliers);
  if (!keeps(half_spaces, answer.point)) return false;
  const Dyadic& w = answer.point.denominator;
  const Dyadic value = dot(answer.point.numbers, objective);
  switch (answer.outcome) {
    case Optimum::all: return std::all_of(objective.begin(), objective.end(), [](double x) { return x == 0; });
    case Optimum::unbounded:
      return recedes(half_spaces, answer.direction) && dot(answer.direction, objective).sign() == Sign::positive;
    case Optimum::many: {
      if (!keeps(half_spaces, answer.other)) return false;
      const Dyadic& v = answer.other.denominator;
      if (!(dot(answer.other.numbers, objective) * w == value * v)) return false;
      bool differ = false;
      for (std::size_t c = 0; c < d; ++c) {
        differ = differ || !(answer.other.numbers[c] * w == answer.point.numbers[c] * v);
      }
      if (!differ) return false;
      break;
    }
    case Optimum::one:
    case Optimum::infeasible: break;
  }
  const auto sum = sum_of(half_spaces, answer.multipliers);
  if (!sum || (answer.outcome == Optimum::one && sum->rank < d)) return false;
  const Dyadic& of = answer.multipliers.denominator;
  for (std::size_t c = 0; c < d; ++c) {
    if (!(sum->row[c] == of * Dyadic(objective[c]))) return false;
  }
  return sum->row[d] * w == value * of;
}

}  // namespace sunder::polytope
