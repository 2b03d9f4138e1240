// Linear relations of few vectors of R^d, in integers: by determinants, or of long integers by elimination.
// Also called: Cramer's rule; kernel (null space) of a matrix with one column more than its rank.
#pragma once

#include <sunder/number/few_words_internal.h>
#include <sunder/number/integer_internal.h>
#include <sunder/polytope/pair/placed.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace sunder::polytope {

inline constexpr std::size_t most_vectors = most_dimension + 1;

// Numbers v, not all zero and the last one not negative, with sum_j v_j c_j = 0 for these vectors c_j; nothing where
// not found, which tells nothing.
//   Floating point says which n of the d equations to solve, of n + 1 vectors; the determinants of these without one of
//   their columns are the numbers, but for signs; the other equations are checked. So what is returned is right, and of
//   vectors of which some n are independent there is no other. Where determinants may be of more than 511 bits, exact
//   elimination finds the numbers (number/exact/elimination_internal.h).
// Requires 1 to d + 1 vectors, of the same d <= 6 numbers. Cost: some n 2^n products of few words and no divisions, or
// some n^3 products and divisions of long integers.
std::optional<std::array<Integer, most_vectors>> null_vector(std::span<const ExactVector> vectors);

// Vectors whose equations are of integers of at most so many bits each: entry [r][j] is that of vector j in equation r.
struct FewWordVectors {
  std::size_t equations = 0, count = 0;
  std::array<std::array<FewWords::Entry, most_vectors>, most_dimension> numbers{};
  std::array<std::int64_t, most_dimension> bits{};

  // Do determinants fit, and sums of their products with numbers of `more` bits?
  bool fit(std::int64_t more = 0) const;
};

// The same of these. Requires that they fit.
std::optional<std::array<FewWords::Number, most_vectors>> null_vector(const FewWordVectors& vectors);

}  // namespace sunder::polytope
