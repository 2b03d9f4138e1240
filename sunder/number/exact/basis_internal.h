// The basis of a revised simplex method: its inverse and the values of its variables, one pivot after another. For
// sources, not installed. In integers, fraction-free: all numbers are times the determinant of the basis (Edmonds 1967,
// Bareiss 1968); or in long floating point, for searches.
//
// The rows are equations A x = r in variables x >= 0, of which columns are found as they are needed. It begins with an
// artificial variable for each row. Phase one is the search for x in which these are zero; the rows of the basis with
// artificial variables sum up to multipliers y that price a column c at y . c: where none has a positive price, y . r
// > 0 shows that there is no x (Farkas).
// The leaving variable is chosen lexicographically, so a method ends whatever the degeneracy (Dantzig, Orden, Wolfe
// 1955).
#pragma once

#include <sunder/number/integer_internal.h>
#include <sunder/number/long_float_internal.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder {

// Which variable: of one of several kinds, the caller's, by its index; of artificial ones that is the row.
struct BasicVariable {
  static constexpr std::uint32_t artificial = 0xffffffffu;
  std::uint32_t kind = artificial;
  std::uint32_t index = 0;
  std::int64_t unit = 0;  // of its column, the caller's: 2^unit is one of the integers
};

struct IntegerArithmetic {
  using Number = Integer;
  static int sign(const Integer& x) { return x.sign(); }
  static void add(Integer& sum, const Integer& x) { sum += x; }
  static void add_product(Integer& sum, const Integer& x, const Integer& y) { sum += x * y; }
  // The sign of p x - q y.
  static int compare(const Integer& p, const Integer& x, const Integer& q, const Integer& y) {
    return (p * x).compare(q * y);
  }
};

struct LongFloatArithmetic {
  using Number = Dyadic;
  LongFloats to;
  static int sign(const Dyadic& x) { return static_cast<int>(x.sign()); }
  void add(Dyadic& sum, const Dyadic& x) const { sum = to.sum(sum, x); }
  void add_product(Dyadic& sum, const Dyadic& x, const Dyadic& y) const { sum = to.sum(sum, to.product(x, y)); }
  int compare(const Dyadic& p, const Dyadic& x, const Dyadic& q, const Dyadic& y) const {
    return sign(to.difference(to.product(p, x), to.product(q, y)));
  }
};

template <class Arithmetic>
class Basis {
 public:
  using Number = typename Arithmetic::Number;
  using Column = std::vector<Number>;

  // Begins with artificial variables; their signs make their values the sizes of the right-hand sides.
  explicit Basis(std::span<const Number> right_hand_sides = {}, Arithmetic arithmetic = {});

  std::size_t rows() const { return rows_; }
  const BasicVariable& variable(std::size_t i) const { return variables_[i]; }
  bool is_artificial(std::size_t i) const { return variables_[i].kind == BasicVariable::artificial; }
  const Number& value(std::size_t i) const { return row(i)[0]; }  // times denominator()
  // Row i of the inverse, times denominator().
  std::span<const Number> inverse(std::size_t i) const { return {row(i) + 1, rows_}; }
  const Number& denominator() const { return denominator_; }  // positive; of long floating point 1

  // The column in terms of the basis, times denominator(): in a buffer that the next call fills.
  const Column& in_terms(std::span<const Number> column);

  // Among rows with t > 0 the lexicographically least (value, inverse) / t; rows() where there is none.
  std::size_t leaving_row(const Column& t);
  // Is the first of value and inverse that is not zero positive?
  bool is_positive(std::size_t i) const;

  // The variable, whose column has these terms, comes in instead of that of row r. Requires t[r] != 0, and of long
  // floating point > 0.
  void pivot(std::size_t r, const BasicVariable& variable, const Column& t);

  // ---- Phase one.

  // The sum of the rows of the inverse with artificial variables.
  const Column& multipliers() const { return multipliers_; }
  Number price(std::span<const Number> column) const;
  // False where the price is not positive; or where no row may leave, which roundings may cause.
  bool enter_if_it_pays(const BasicVariable& variable, std::span<const Number> column);
  bool is_solved() const;  // all artificial variables are zero

  std::uint32_t pivots() const { return pivots_; }
  std::uint32_t comparisons() const { return comparisons_; }  // of products, by leaving_row()

 private:
  Number* row(std::size_t i) { return &table_[i * (rows_ + 1)]; }
  const Number* row(std::size_t i) const { return &table_[i * (rows_ + 1)]; }
  void set_multipliers();
  bool is_less(std::size_t i, std::size_t j, const Column& t);

  Arithmetic arithmetic_;
  std::size_t rows_;
  std::vector<BasicVariable> variables_;
  Column table_;  // of each row the value, then the inverse
  Column multipliers_, terms_;
  Number denominator_ = 1;
  std::uint32_t pivots_ = 0, comparisons_ = 0;
};

template <>
void Basis<IntegerArithmetic>::pivot(std::size_t r, const BasicVariable& variable, const Column& t);
template <>
void Basis<LongFloatArithmetic>::pivot(std::size_t r, const BasicVariable& variable, const Column& t);
extern template class Basis<IntegerArithmetic>;
extern template class Basis<LongFloatArithmetic>;

using IntegerBasis = Basis<IntegerArithmetic>;
using LongFloatBasis = Basis<LongFloatArithmetic>;

}  // namespace sunder
