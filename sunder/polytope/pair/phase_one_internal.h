// Phase one of the revised simplex method in integers: are there weights l >= 0 of columns, found as they are needed,
// with sum l_k c_k = e, where e is a last unit vector, or several?
// Arithmetic is fraction-free: the inverse of the basis times its determinant (Edmonds 1967, Bareiss 1968). The leaving
// variable is chosen lexicographically (Dantzig, Orden, Wolfe 1955), so the method ends whatever the degeneracy.
#pragma once

#include <sunder/number/integer_internal.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::polytope {

// Which column: of one of several kinds, the caller's, by its index.
struct Variable {
  static constexpr std::uint32_t artificial = 0xffffffffu;
  std::uint32_t kind = artificial;
  std::uint32_t index = 0;
};

class PhaseOne {
 public:
  // The last `ones` of the right-hand sides are 1, the others 0.
  PhaseOne(std::size_t rows, std::size_t ones);

  // Does the column have a positive price with the multipliers? Then it enters the basis, and the multipliers change.
  // It is an exact column, in the order of the rows.
  bool enter_if_it_pays(const Variable& variable, std::span<const Dyadic> column);

  // y: prices are y . c. Where no column has a positive one and the system is not solved, y . e > 0 shows that it has
  // no solution.
  std::vector<Dyadic> multipliers() const;

  bool is_solved() const;  // no artificial variable has a weight

  // Of the variables in the basis that have one, the weights times denominator(), which is positive.
  struct Weight {
    Variable variable;
    Dyadic numerator;
  };
  std::vector<Weight> weights() const;
  Dyadic denominator() const { return dyadic_of(determinant_, 0); }
  std::uint32_t pivots() const { return pivots_; }

 private:
  using Column = std::vector<Integer>;
  std::size_t leaving_row(const Column& t) const;
  bool lexicographically_less(std::size_t i, std::size_t j, const Column& t) const;

  std::size_t rows_;
  std::vector<Variable> basis_;
  std::vector<std::int64_t> units_;  // of the basic columns: 2^unit is one of their integers
  Integer determinant_ = 1;          // of the basis, as its absolute value
  std::vector<Column> inverse_;      // of the basis, times determinant_, row by row
  Column solution_;                  // times determinant_
  std::uint32_t pivots_ = 0;
};

}  // namespace sunder::polytope
