// What proofs about half-spaces are made of, checked in exact numbers.
#pragma once

#include <sunder/polytope/pair/evidence.h>
#include <sunder/polytope/pair/placed.h>

#include <cstddef>
#include <optional>
#include <span>

namespace sunder::polytope {

// Is the point in all half-spaces?
bool keeps(const Polytope& body, const ExactPointN& point);

// Does no half-space end along the direction, which is not zero?
bool recedes(const Polytope& body, std::span<const Dyadic> direction);

// The sum of rows (a, b) by multipliers, over their denominator, and the rank of the normals; nothing where a
// multiplier is not positive, or of no row.
struct SumOfRows {
  ExactVector row;
  std::size_t rank;
};
std::optional<SumOfRows> sum_of(const Polytope& body, const Weights& multipliers);

// Is the sum 0 . x <= a negative number?
bool contradicts(const Polytope& body, const Weights& multipliers);

}  // namespace sunder::polytope
