#include <sunder/base/contract.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/number/exact/scaled_integers_internal.h>
#include <sunder/number/exact_division_internal.h>

#include <algorithm>
#include <utility>

namespace sunder {

// With D the pivot, D v - sum v_p r_p over rows r with pivots in columns p has 0 in all of these, and is minors of one
// row more. For each row r, (r w_q - w r_q) / D, where q is the column of the new pivot, is whole (Sylvester).
bool Elimination::add(std::vector<Integer> row) {
  SUNDER_REQUIRE(row.size() == width_);
  std::vector<Integer> w = row;
  if (!rows_.empty()) {
    for (Integer& x : w) x *= pivot_;
  }
  for (const Row& r : rows_) {
    const Integer& factor = row[r.column];
    if (factor.is_zero()) continue;
    for (std::size_t k = 0; k < width_; ++k) {
      if (!r.numbers[k].is_zero()) w[k] -= factor * r.numbers[k];
    }
  }
  const auto end = w.begin() + static_cast<std::ptrdiff_t>(pivot_columns_);
  const auto found = std::find_if(w.begin(), end, [](const Integer& x) { return !x.is_zero(); });
  if (found == end) return false;
  if (*found < 0) {
    for (Integer& x : w) x.backend().negate();
  }
  const auto column = static_cast<std::size_t>(found - w.begin());
  for (Row& r : rows_) {
    const Integer factor = r.numbers[column];
    for (std::size_t k = 0; k < width_; ++k) {
      Integer& x = r.numbers[k];
      x *= w[column];
      if (!factor.is_zero() && !w[k].is_zero()) x -= factor * w[k];
      if (!x.is_zero()) divide_exactly(x, pivot_);
    }
  }
  pivot_ = w[column];
  rows_.push_back({column, std::move(w)});
  return true;
}

bool Elimination::add(std::span<const Dyadic> row) { return add(scaled_integers(row).integers); }

std::optional<std::vector<Integer>> Elimination::across() const {
  std::size_t free = 0;
  const auto is_pivot = [&](std::size_t k) {
    return std::any_of(rows_.begin(), rows_.end(), [&](const Row& row) { return row.column == k; });
  };
  while (free < width_ && is_pivot(free)) ++free;
  if (free == width_) return std::nullopt;
  std::vector<Integer> result(width_);
  Integer common = pivot_;
  result[free] = -pivot_;
  for (const Row& row : rows_) {
    result[row.column] = row.numbers[free];
    common = gcd(common, result[row.column]);
  }
  for (Integer& x : result) x /= common;
  return result;
}

std::optional<ExactInverse> exact_inverse(std::size_t d, std::span<const double> matrix) {
  SUNDER_REQUIRE(matrix.size() == d * d);
  const ScaledIntegers whole = scaled_integers(std::vector<Dyadic>(matrix.begin(), matrix.end()));
  Elimination beside_identity(2 * d, d);
  for (std::size_t i = 0; i < d; ++i) {
    const auto begin = whole.integers.begin() + static_cast<std::ptrdiff_t>(i * d);
    std::vector<Integer> row(begin, begin + static_cast<std::ptrdiff_t>(d));
    row.resize(2 * d);
    row[d + i] = 1;
    if (!beside_identity.add(std::move(row))) return std::nullopt;
  }
  ExactInverse result{std::vector<Dyadic>(d * d), dyadic_of(beside_identity.pivot(), whole.unit)};
  for (const Elimination::Row& row : beside_identity.rows()) {
    for (std::size_t c = 0; c < d; ++c) result.numbers[row.column * d + c] = dyadic_of(row.numbers[d + c], 0);
  }
  return result;
}

}  // namespace sunder
