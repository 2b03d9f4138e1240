#include <sunder/base/contract.h>
#include <sunder/number/exact/basis_internal.h>
#include <sunder/number/exact_division_internal.h>

namespace sunder {

template <class Arithmetic>
Basis<Arithmetic>::Basis(std::span<const Number> right_hand_sides, Arithmetic arithmetic)
    : arithmetic_(arithmetic), rows_(right_hand_sides.size()), variables_(rows_), table_(rows_ * (rows_ + 1)) {
  for (std::size_t i = 0; i < rows_; ++i) {
    const bool is_negative = Arithmetic::sign(right_hand_sides[i]) < 0;
    variables_[i].index = static_cast<std::uint32_t>(i);
    row(i)[0] = is_negative ? -right_hand_sides[i] : right_hand_sides[i];
    row(i)[1 + i] = is_negative ? -1 : 1;
  }
  set_multipliers();
}

template <class Arithmetic>
void Basis<Arithmetic>::set_multipliers() {
  multipliers_.assign(rows_, Number());
  for (std::size_t i = 0; i < rows_; ++i) {
    if (!is_artificial(i)) continue;
    for (std::size_t k = 0; k < rows_; ++k) arithmetic_.add(multipliers_[k], row(i)[1 + k]);
  }
}

template <class Arithmetic>
auto Basis<Arithmetic>::in_terms(std::span<const Number> column) -> const Column& {
  SUNDER_REQUIRE(column.size() == rows_);
  terms_.assign(rows_, Number());
  for (std::size_t k = 0; k < rows_; ++k) {
    if (Arithmetic::sign(column[k]) == 0) continue;
    for (std::size_t i = 0; i < rows_; ++i) {
      const Number& x = row(i)[1 + k];
      if (Arithmetic::sign(x) != 0) arithmetic_.add_product(terms_[i], x, column[k]);
    }
  }
  return terms_;
}

template <class Arithmetic>
std::size_t Basis<Arithmetic>::leaving_row(const Column& t) {
  std::size_t best = rows_;
  for (std::size_t i = 0; i < rows_; ++i) {
    if (Arithmetic::sign(t[i]) > 0 && (best == rows_ || is_less(i, best, t))) best = i;
  }
  return best;
}

template <class Arithmetic>
bool Basis<Arithmetic>::is_less(std::size_t i, std::size_t j, const Column& t) {
  int order = 0;
  for (std::size_t k = 0; order == 0 && k <= rows_; ++k) {
    order = arithmetic_.compare(row(i)[k], t[j], row(j)[k], t[i]);
    ++comparisons_;
  }
  return order < 0;
}

template <class Arithmetic>
bool Basis<Arithmetic>::is_positive(std::size_t i) const {
  std::size_t k = 0;
  while (k < rows_ && Arithmetic::sign(row(i)[k]) == 0) ++k;
  return Arithmetic::sign(row(i)[k]) > 0;
}

template <>
void Basis<IntegerArithmetic>::pivot(std::size_t r, const BasicVariable& variable, const Column& t) {
  SUNDER_REQUIRE(!t[r].is_zero());
  const Integer* const leaving = row(r);
  const bool is_first = denominator_ == 1, is_negative = t[r] < 0;
  for (std::size_t i = 0; i < rows_; ++i) {
    if (i == r) continue;
    for (std::size_t k = 0; k <= rows_; ++k) {  // zeros are many, to begin with
      Integer& x = row(i)[k];
      const bool is_changed = !leaving[k].is_zero() && !t[i].is_zero();
      if (x.is_zero() && !is_changed) continue;
      x *= t[r];
      if (is_changed) x -= leaving[k] * t[i];
      if (!is_first) divide_exactly(x, denominator_);
      if (is_negative) x.backend().negate();
    }
  }
  denominator_ = t[r];
  if (is_negative) {
    denominator_.backend().negate();
    for (std::size_t k = 0; k <= rows_; ++k) row(r)[k].backend().negate();
  }
  variables_[r] = variable;
  ++pivots_;
  set_multipliers();
}

template <>
void Basis<LongFloatArithmetic>::pivot(std::size_t r, const BasicVariable& variable, const Column& t) {
  SUNDER_REQUIRE(t[r].sign() == Sign::positive);
  Dyadic* const entering = row(r);
  for (std::size_t k = 0; k <= rows_; ++k) entering[k] = arithmetic_.to.quotient(entering[k], t[r]);
  for (std::size_t i = 0; i < rows_; ++i) {
    if (i == r || t[i].sign() == Sign::zero) continue;
    const Dyadic by = -t[i];
    for (std::size_t k = 0; k <= rows_; ++k) {
      if (entering[k].sign() != Sign::zero) arithmetic_.add_product(row(i)[k], entering[k], by);
    }
  }
  variables_[r] = variable;
  ++pivots_;
  set_multipliers();
}

template <class Arithmetic>
auto Basis<Arithmetic>::price(std::span<const Number> column) const -> Number {
  SUNDER_REQUIRE(column.size() == rows_);
  Number sum{};
  for (std::size_t k = 0; k < rows_; ++k) {
    if (Arithmetic::sign(column[k]) != 0 && Arithmetic::sign(multipliers_[k]) != 0) {
      arithmetic_.add_product(sum, multipliers_[k], column[k]);
    }
  }
  return sum;
}

template <class Arithmetic>
bool Basis<Arithmetic>::enter_if_it_pays(const BasicVariable& variable, std::span<const Number> column) {
  if (Arithmetic::sign(price(column)) <= 0) return false;
  const Column& t = in_terms(column);
  const std::size_t r = leaving_row(t);
  if (r == rows_) return false;
  pivot(r, variable, t);
  return true;
}

template <class Arithmetic>
bool Basis<Arithmetic>::is_solved() const {
  for (std::size_t i = 0; i < rows_; ++i) {
    if (is_artificial(i) && Arithmetic::sign(value(i)) != 0) return false;
  }
  return true;
}

template class Basis<IntegerArithmetic>;
template class Basis<LongFloatArithmetic>;

}  // namespace sunder
