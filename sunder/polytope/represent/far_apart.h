// Points that span a simplex, in floating point: it proposes, and nothing about it is believed.
// Also called: furthest-first traversal; Gram-Schmidt orthogonalization with pivoting.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace sunder::polytope {

// d + 1 of the points, given d after d: the first one, or else the furthest from the origin; then each the furthest
// from the flat of those before it. Fewer where the square of that distance is not above `least`. Cost: d passes over
// all.
std::vector<std::uint32_t> far_apart(std::size_t d, std::vector<double> points, std::optional<std::uint32_t> first,
                                     double least);

}  // namespace sunder::polytope
