// Rows of numbers that lie in a flat of R^d: which of their columns tell the others, exactly. So flat bodies are bodies
// of fewer dimensions.
// Also called: affine hull; reduced row echelon form.
#pragma once

#include <sunder/number/dyadic.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace sunder::polytope {

// Of rows x and x0, the difference is the sum over the columns of (x - x0)_column / pivot times the vector, which has
// the pivot, a positive number, in its column, and 0 in the others'.
struct AffineColumns {
  struct Column {
    std::size_t column = 0;
    std::vector<Dyadic> vector;
  };
  std::vector<Column> columns;  // by number; as many as the flat has dimensions
  Dyadic pivot{1.0};

  // A direction of as many components as there are columns, whose products with the columns of rows are, but for a
  // positive factor and a number that all rows share, those of the direction with the rows.
  std::vector<Dyadic> reduced(std::span<const Dyadic> direction) const;
};

// row(k): d numbers. Cost: in general d rows; of a flat set all of them, in exact arithmetic.
AffineColumns affine_columns(std::size_t d, std::size_t count,
                             const std::function<std::span<const double>(std::size_t)>& row);

}  // namespace sunder::polytope
