// Phase one of the revised simplex method in integers (number/exact/basis_internal.h), of columns of exact numbers: are
// there weights l >= 0 of columns, found as they are needed, with sum l_k c_k = e, where e is a last unit vector, or
// several?
#pragma once

#include <sunder/number/exact/basis_internal.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::polytope {

class PhaseOne {
 public:
  // The last `ones` of the right-hand sides are 1, the others 0.
  PhaseOne(std::size_t rows, std::size_t ones);

  // Does the column have a positive price with the multipliers? Then it enters the basis, and the multipliers change.
  // It is an exact column, in the order of the rows.
  bool enter_if_it_pays(BasicVariable variable, std::span<const Dyadic> column);

  // y: prices are y . c. Where no column has a positive one and the system is not solved, y . e > 0 shows that it has
  // no solution.
  std::vector<Dyadic> multipliers() const;

  bool is_solved() const { return basis_.is_solved(); }  // no artificial variable has a weight

  // Of the variables in the basis that have one, the weights times denominator(), which is positive.
  struct Weight {
    BasicVariable variable;
    Dyadic numerator;
  };
  std::vector<Weight> weights() const;
  Dyadic denominator() const { return dyadic_of(basis_.denominator(), 0); }

 private:
  IntegerBasis basis_;
};

}  // namespace sunder::polytope
