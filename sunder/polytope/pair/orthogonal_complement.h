// The vectors that are orthogonal to some of R^n, 2 <= n <= 7, in floating point. It proposes, and may be wrong.
// Also called: orthogonal complement; null space by Householder's reflections.
#pragma once

#include <sunder/predicate/filter/along_columns.h>

#include <array>
#include <cstddef>

namespace sunder::polytope {

class OrthogonalComplement {
 public:
  explicit OrthogonalComplement(std::size_t n);  // of no vectors: all of R^n

  std::size_t dimension() const { return dimension_; }
  const ColumnNumbers& base(std::size_t k) const { return base_[k]; }  // of length 1, orthogonal to one another

  // Of the part of a vector that is in the complement, the coordinates; and the vector that has some.
  ColumnNumbers coordinates(const ColumnNumbers& vector) const;
  ColumnNumbers vector(const ColumnNumbers& coordinates) const;

  // From now on orthogonal to this vector as well. False, and as before, where about nothing of it is in the
  // complement.
  bool take_out(const ColumnNumbers& vector);

 private:
  std::size_t n_, dimension_;
  std::array<ColumnNumbers, most_columns> base_{};
};

}  // namespace sunder::polytope
