#include <sunder/base/contract.h>
#include <sunder/number/exact_division_internal.h>
#include <sunder/oracle/dictionary_internal.h>

#include <algorithm>
#include <utility>

namespace sunder::oracle {

namespace {

std::optional<std::size_t> place_of(const std::vector<std::int64_t>& variables, std::int64_t variable) {
  const auto found = std::find(variables.begin(), variables.end(), variable);
  if (found == variables.end()) return std::nullopt;
  return static_cast<std::size_t>(found - variables.begin());
}

}  // namespace

std::optional<std::size_t> Dictionary::leaving(std::size_t column) const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i][column] <= 0) continue;
    if (best) {
      const int order = (rows[i].back() * rows[*best][column]).compare(rows[*best].back() * rows[i][column]);
      if (order > 0 || (order == 0 && basic[i] > basic[*best])) continue;
    }
    best = i;
  }
  return best;
}

// x_r = (b - sum a_j x_j) / D, so x_c = (b - sum' a_j x_j - D x_r) / a_c. Each other row (b' - sum a'_j x_j) / D has
// then (b' a_c - a'_c b) / D, and so on, over a_c: whole, as all are minors of the first rows.
void Dictionary::pivot(std::size_t r, std::size_t c) {
  Integers& own = rows[r];
  const Integer by = own[c];
  SUNDER_REQUIRE(!by.is_zero());
  const bool is_negative = by < 0;
  const auto replace = [&](Integers& row) {
    const Integer factor = row[c];
    for (std::size_t j = 0; j < row.size(); ++j) {
      Integer& x = row[j];
      if (j == c || (x.is_zero() && (factor.is_zero() || own[j].is_zero()))) continue;
      x *= by;
      if (!factor.is_zero() && !own[j].is_zero()) x -= factor * own[j];
      if (denominator != 1) divide_exactly(x, denominator);
      if (is_negative) x = -x;
    }
    row[c] = is_negative ? factor : -factor;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i != r) replace(rows[i]);
  }
  for (Integers& objective : objectives) replace(objective);
  own[c] = denominator;
  if (is_negative) {
    for (Integer& x : own) x = -x;
  }
  denominator = is_negative ? -by : by;
  std::swap(basic[r], others[c]);
}

void Dictionary::begin_phase_one() {
  objectives.assign(1, Integers(others.size() + 1));
  for (const Integers& row : rows) {
    for (std::size_t j = 0; j < row.size(); ++j) objectives[0][j] -= row[j];
  }
}

// The objective z has the coefficient -y . column for each column, and 1 - y_k for an artificial variable, all times the
// denominator.
Integer Dictionary::multiplier(std::int64_t artificial) const {
  const auto column = column_of(artificial);
  return column ? denominator - objectives[0][*column] : denominator;
}

Integer Dictionary::inverse(std::size_t i, std::int64_t artificial) const {
  if (const auto column = column_of(artificial)) return rows[i][*column];
  return basic[i] == artificial ? denominator : Integer(0);
}

void Dictionary::add_column(std::int64_t variable, std::span<const Integer> column, std::int64_t first) {
  SUNDER_REQUIRE(objectives.empty());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Integer term = 0;
    for (std::size_t k = 0; k < column.size(); ++k) {
      if (!column[k].is_zero()) term += inverse(i, first + static_cast<std::int64_t>(k)) * column[k];
    }
    rows[i].insert(rows[i].end() - 1, std::move(term));
  }
  others.push_back(variable);
}

void Dictionary::drop_last_column() {
  others.pop_back();
  for (Integers& row : rows) row.erase(row.end() - 2);
}

std::optional<std::size_t> Dictionary::row_of(std::int64_t variable) const { return place_of(basic, variable); }
std::optional<std::size_t> Dictionary::column_of(std::int64_t variable) const { return place_of(others, variable); }

}  // namespace sunder::oracle
