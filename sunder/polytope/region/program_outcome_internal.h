// The outcome of a linear program from the last basis of the dual simplex method.
#pragma once

#include <sunder/polytope/region/dual_simplex_internal.h>
#include <sunder/polytope/region/linear_program.h>

namespace sunder::polytope {

// Goes on from a basis, to the end. The objective is exact, so that it may be any.
LinearProgramAnswer decide_from(const Polytope& half_spaces, std::span<const Dyadic> objective, const RowBasis& basis);

// The box: where there is nothing better to begin with.
RowBasis basis_of_box(std::size_t dimension);

}  // namespace sunder::polytope
