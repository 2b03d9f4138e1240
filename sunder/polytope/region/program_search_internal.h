// Searches in floating point for the last basis of a linear program: proposals, which may be wrong.
#pragma once

#include <sunder/polytope/region/dual_simplex_internal.h>

#include <array>
#include <cstdint>
#include <span>

namespace sunder::polytope {

// A maximum of c . x over the half-spaces, and the box (dual_simplex_internal.h), by the dual simplex method. Requires
// a polytope of half-spaces. Cost: a scan a step, at most some 60 d. Allocates nothing.
RowBasis basis_by_scans(const Polytope& half_spaces, std::span<const double> objective);

// By Seidel's method. Cost: O(d! N) expected rows. Allocates some d N numbers.
RowBasis basis_by_seidel(const Polytope& half_spaces, std::span<const double> objective);

}  // namespace sunder::polytope
