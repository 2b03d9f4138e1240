// Is a direction of R^d, d at most 7, in the cone of d generators? By its weights, that is, its coordinates in terms of
// them: a product with nearly the inverse of their matrix, which is verified once.
// Also called: barycentric (conic) coordinates; verified solution of a linear system; Krawczyk, Rump.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/filter/along_columns.h>

#include <array>
#include <cstddef>
#include <span>

namespace sunder {

// Nearly the inverse of the matrix C whose columns are the generators, row by row, into `inverse`; returned is a slack,
// a bound q / (1 - q) where q >= |I - inverse C| (of rows: the greatest sum of sizes), rounding included. Infinite
// where the inverse is of no use, or anything may have overflowed. generators: d after d. Requires 2 <= d <= 7.
double cone_inverse(std::span<const double> generators, std::size_t d, std::span<double> inverse);

struct ConeWeights {
  std::array<double, most_columns> weight{};  // as floating point has it
  std::array<Guess, most_columns> sign{};     // of the exact one
};

// Of a direction whose components are the exact ones but for a relative error of 2^-53 each. With E = I - R C and
// l = C^-1 u, R u = l - E l, so |l - R u| <= |E| |l| and |l| <= |R u| / (1 - |E|), by greatest sizes.
ConeWeights cone_weights(std::span<const double> inverse, double slack, std::span<const double> direction,
                         std::size_t d);

// The product of the generator with v - w, enclosed: at most `most`, at least `least`. Infinite where anything may have
// overflowed.
struct ProductRange {
  double least = 0, most = 0;
};
ProductRange difference_along(std::span<const double> generator, std::span<const double> v, std::span<const double> w);

}  // namespace sunder
