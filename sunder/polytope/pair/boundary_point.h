// A point on the boundaries of half-spaces a . x <= b, exactly, near one of floating point.
#pragma once

#include <sunder/polytope/pair/placed.h>
#include <sunder/predicate/exact_point.h>

#include <optional>
#include <span>

namespace sunder::polytope {

// For as many coordinates as boundaries are independent, in floating point, the equations are solved by determinants;
// the others are those of the point given, rounded to 2^-40 units. Nothing where no boundary has a normal, or those
// chosen are not independent. Of boundaries that depend on these, only floating point knows that the point is on them.
// Requires rows a1, .., ad, b, of at most d + 1 half-spaces, d <= 6, and a unit that is a power of two.
std::optional<ExactPointN> boundary_point(std::span<const ExactVector> rows, const ColumnNumbers& near, double unit);

}  // namespace sunder::polytope
