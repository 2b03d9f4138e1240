#include <sunder/base/contract.h>
#include <sunder/number/exact_division_internal.h>
#include <sunder/polytope/pair/phase_one_internal.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace sunder::polytope {

PhaseOne::PhaseOne(std::size_t rows, std::size_t ones)
    : rows_(rows), basis_(rows), units_(rows), inverse_(rows, Column(rows)), solution_(rows) {
  for (std::size_t i = 0; i < rows; ++i) {
    inverse_[i][i] = 1;
    solution_[i] = i + ones >= rows ? 1 : 0;
  }
}

std::vector<Dyadic> PhaseOne::multipliers() const {
  Column y(rows_);
  for (std::size_t i = 0; i < rows_; ++i) {
    if (basis_[i].kind != Variable::artificial) continue;
    for (std::size_t k = 0; k < rows_; ++k) y[k] += inverse_[i][k];
  }
  std::vector<Dyadic> result;
  for (const Integer& n : y) result.push_back(dyadic_of(n, 0));
  return result;
}

bool PhaseOne::is_solved() const {
  for (std::size_t i = 0; i < rows_; ++i) {
    if (basis_[i].kind == Variable::artificial && !solution_[i].is_zero()) return false;
  }
  return true;
}

std::vector<PhaseOne::Weight> PhaseOne::weights() const {
  std::vector<Weight> result;
  for (std::size_t i = 0; i < rows_; ++i) {
    if (basis_[i].kind == Variable::artificial || solution_[i].is_zero()) continue;
    result.push_back({basis_[i], dyadic_of(solution_[i], -units_[i])});
  }
  return result;
}

bool PhaseOne::enter_if_it_pays(const Variable& variable, std::span<const Dyadic> column) {
  SUNDER_REQUIRE(column.size() == rows_);
  std::int64_t unit = std::numeric_limits<std::int64_t>::max();
  for (const Dyadic& x : column) {
    if (x.sign() != Sign::zero) unit = std::min(unit, x.exponent());
  }
  if (unit == std::numeric_limits<std::int64_t>::max()) return false;
  Column c(rows_);
  for (std::size_t k = 0; k < rows_; ++k) {
    if (column[k].sign() != Sign::zero) {
      c[k] = mantissa_of(column[k]) << static_cast<unsigned>(column[k].exponent() - unit);
    }
  }
  Column t(rows_);  // the column in terms of the basis, times determinant_
  Integer price = 0;
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t k = 0; k < rows_; ++k) {
      if (!inverse_[i][k].is_zero()) t[i] += inverse_[i][k] * c[k];
    }
    if (basis_[i].kind == Variable::artificial) price += t[i];
  }
  if (price <= 0) return false;
  const std::size_t r = leaving_row(t);
  const auto replace = [&](Integer& x, const Integer& of_r, const Integer& t_i) {  // zeros are many, to begin with
    const bool is_changed = !of_r.is_zero() && !t_i.is_zero();
    if (x.is_zero() && !is_changed) return;
    x *= t[r];
    if (is_changed) x -= of_r * t_i;
    if (pivots_ > 0) divide_exactly(x, determinant_);  // 1 before the first
  };
  for (std::size_t i = 0; i < rows_; ++i) {
    if (i == r) continue;
    for (std::size_t k = 0; k < rows_; ++k) replace(inverse_[i][k], inverse_[r][k], t[i]);
    replace(solution_[i], solution_[r], t[i]);
  }
  determinant_ = t[r];
  basis_[r] = variable;
  units_[r] = unit;
  ++pivots_;
  return true;
}

// Among rows with t > 0 (there is one: the price is the sum of t over artificial rows), the one with the
// lexicographically least (solution, inverse) / t.
std::size_t PhaseOne::leaving_row(const Column& t) const {
  std::size_t best = rows_;
  for (std::size_t i = 0; i < rows_; ++i) {
    if (t[i] > 0 && (best == rows_ || lexicographically_less(i, best, t))) best = i;
  }
  return best;
}

bool PhaseOne::lexicographically_less(std::size_t i, std::size_t j, const Column& t) const {
  int order = (solution_[i] * t[j]).compare(solution_[j] * t[i]);
  for (std::size_t k = 0; order == 0 && k < rows_; ++k) {
    order = (inverse_[i][k] * t[j]).compare(inverse_[j][k] * t[i]);
  }
  return order < 0;
}

}  // namespace sunder::polytope
