#include <sunder/base/contract.h>
#include <sunder/polytope/region/exact_rank_internal.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace sunder::polytope {

namespace {

// Divided by what all have in common.
void reduce(std::vector<Integer>& numbers) {
  Integer common = 0;
  for (const Integer& x : numbers) common = gcd(common, x);
  if (common > 1) {
    for (Integer& x : numbers) x /= common;
  }
}

}  // namespace

bool ExactSpan::add(std::span<const Dyadic> vector) {
  SUNDER_REQUIRE(vector.size() == width_);
  std::int64_t unit = std::numeric_limits<std::int64_t>::max();
  for (const Dyadic& x : vector) {
    if (x.sign() != Sign::zero) unit = std::min(unit, x.exponent());
  }
  if (unit == std::numeric_limits<std::int64_t>::max()) return false;
  std::vector<Integer> numbers(width_);
  for (std::size_t k = 0; k < width_; ++k) {
    if (vector[k].sign() == Sign::zero) continue;
    numbers[k] = mantissa_of(vector[k]) << static_cast<unsigned>(vector[k].exponent() - unit);
  }
  const auto clear = [&](std::vector<Integer>& of, const std::vector<Integer>& by, std::size_t pivot) {
    const Integer factor = of[pivot], own = by[pivot];
    if (factor.is_zero()) return;
    for (std::size_t k = 0; k < width_; ++k) of[k] = of[k] * own - by[k] * factor;
    reduce(of);
  };
  for (const Row& row : rows_) clear(numbers, row.numbers, row.pivot);
  const auto found = std::find_if(numbers.begin(), numbers.end(), [](const Integer& x) { return !x.is_zero(); });
  if (found == numbers.end()) return false;
  const auto pivot = static_cast<std::size_t>(found - numbers.begin());
  reduce(numbers);
  for (Row& row : rows_) clear(row.numbers, numbers, pivot);
  rows_.push_back({std::move(numbers), pivot});
  return true;
}

std::optional<ExactVector> ExactSpan::across() const {
  std::size_t free = 0;
  const auto is_pivot = [&](std::size_t k) {
    return std::any_of(rows_.begin(), rows_.end(), [&](const Row& row) { return row.pivot == k; });
  };
  while (free < width_ && is_pivot(free)) ++free;
  if (free == width_) return std::nullopt;
  // One at `free`; at each pivot, what that row asks for; all times the product of the pivots.
  std::vector<Integer> numbers(width_);
  numbers[free] = 1;
  for (const Row& row : rows_) {
    const Integer own = row.numbers[row.pivot], at_free = row.numbers[free] * numbers[free];
    for (Integer& x : numbers) x *= own;
    numbers[row.pivot] = -at_free;
  }
  reduce(numbers);
  ExactVector result;
  for (const Integer& x : numbers) result.push_back(dyadic_of(x, 0));
  return result;
}

}  // namespace sunder::polytope
