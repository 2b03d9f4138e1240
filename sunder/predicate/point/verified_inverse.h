// Nearly the inverse of a small matrix, by elimination in floating point, and a proved bound of how far off it is.
// Also called: verified (self-validating) solution of a linear system; Krawczyk, Rump.
#pragma once

#include <cstddef>
#include <span>

namespace sunder {

inline constexpr std::size_t most_verified_rows = 7;

// R, nearly the inverse of the matrix M, row by row, and a bound q of |I - R M'| (of rows: the greatest sum of sizes)
// for all M' whose rows differ from those of M by `width` in all: of row k the sum of sizes of differences is at most
// width[k]. Returns q, all roundings included; infinite where the inverse is of no use, or anything may have
// overflowed. Requires n x n numbers in both, n widths that are not negative, and 1 <= n <= 7.
//   With E = I - R M' and q < 1, M' is regular, and |M'^-1 e - m| <= |R (e - M' m)| / (1 - q) for any m, by greatest
// sizes.
double verified_inverse(std::span<const double> matrix, std::span<const double> width, std::span<double> inverse);

}  // namespace sunder
