#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/region/linear_program.h>
#include <sunder/polytope/region/rows_check_internal.h>

#include <algorithm>
#include <variant>

namespace sunder::polytope {

const ExactPointN* named_point(const ProgramEvidence& evidence) {
  return std::visit(
      [](const auto& held) -> const ExactPointN* {
        if constexpr (requires { held.point; }) return &held.point;
        return nullptr;
      },
      evidence);
}

const Weights* named_multipliers(const ProgramEvidence& evidence) {
  return std::visit(
      [](const auto& held) -> const Weights* {
        if constexpr (requires { held.multipliers; }) return &held.multipliers;
        return nullptr;
      },
      evidence);
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

namespace {

struct ProgramChecker {
  const Polytope& half_spaces;
  std::span<const double> objective;

  // Is no point better? least_rank: of the span of the normals.
  bool is_best(const ExactPointN& point, const Weights& multipliers, std::size_t least_rank) const {
    const std::size_t d = half_spaces.dimension();
    if (!keeps(half_spaces, point)) return false;
    const auto sum = sum_of(half_spaces, multipliers);
    if (!sum || sum->rank < least_rank) return false;
    const Dyadic& of = multipliers.denominator;
    for (std::size_t c = 0; c < d; ++c) {
      if (!(sum->row[c] == of * Dyadic(objective[c]))) return false;
    }
    return sum->row[d] * point.denominator == dot(point.numbers, objective) * of;
  }

  bool operator()(const OneOptimum& one) const { return is_best(one.point, one.multipliers, half_spaces.dimension()); }
  bool operator()(const ManyOptima& many) const {
    if (!is_best(many.point, many.multipliers, 0) || !keeps(half_spaces, many.other)) return false;
    const Dyadic &w = many.point.denominator, &v = many.other.denominator;
    if (!(dot(many.other.numbers, objective) * w == dot(many.point.numbers, objective) * v)) return false;
    bool differ = false;
    for (std::size_t c = 0; c < half_spaces.dimension(); ++c) {
      differ = differ || !(many.other.numbers[c] * w == many.point.numbers[c] * v);
    }
    return differ;
  }
  bool operator()(const AnyPoint& any) const {
    return keeps(half_spaces, any.point) &&
           std::all_of(objective.begin(), objective.end(), [](double x) { return x == 0; });
  }
  bool operator()(const NoBound& far) const {
    return keeps(half_spaces, far.point) && recedes(half_spaces, far.direction) &&
           dot(far.direction, objective).sign() == Sign::positive;
  }
  bool operator()(const NoPoint& none) const { return contradicts(half_spaces, none.multipliers); }
};

}  // namespace

bool check(const Polytope& half_spaces, std::span<const double> objective, const LinearProgramAnswer& answer) {
  return std::visit(ProgramChecker{half_spaces, objective}, answer.evidence);
}

}  // namespace sunder::polytope
