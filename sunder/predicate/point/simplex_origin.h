// Does the simplex of d + 1 points of R^d hold the origin inside of it? By a linear system that is solved in floating
// point, and then verified: all roundings are bounded.
// Also called: verified (self-validating) solution of a linear system; Krawczyk, Rump.
#pragma once

#include <sunder/number/interval.h>
#include <sunder/number/sign.h>

#include <cstddef>
#include <span>

namespace sunder {

// The sign of the least weight of the origin, as a combination of the points whose weights sum to 1: positive, or
// unsure. points: of each its d intervals, 2 <= d <= 6.
//   Let M be the matrix with a column for each point, a 1 below it, and R nearly its inverse; l = M^-1 e, where e is
// the last unit vector, has the weights. With E = I - R M and a norm |E| <= q < 1 (of rows: the greatest sum of sizes),
// M is regular, and for any m: |l - m| <= |R (e - M m)| / (1 - q).
Guess least_weight_of_origin(std::span<const Interval> points, std::size_t d);

}  // namespace sunder
