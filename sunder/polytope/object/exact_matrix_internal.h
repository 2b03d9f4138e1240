// Inverses of small matrices in integers.
#pragma once

#include <sunder/number/integer_internal.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace sunder::polytope {

// The inverse of a matrix is `numbers` over `denominator`, which is positive; row by row.
struct ExactInverse {
  std::vector<Dyadic> numbers;
  Dyadic denominator{1.0};
};

// Of a d x d matrix of finite doubles, row by row; nothing where it is singular. By elimination without fractions
// (Bareiss 1968). Allocates.
std::optional<ExactInverse> exact_inverse(std::size_t dimension, std::span<const double> matrix);

}  // namespace sunder::polytope
