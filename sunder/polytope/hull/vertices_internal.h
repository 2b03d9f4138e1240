// The vertices of half-spaces with exact numbers, seen from a point inside: what vertices.h and region_vertices.h have
// in common.
#pragma once

#include <sunder/polytope/hull/vertices.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace sunder::polytope {

// Adds E1 to E3, E5 and the cost, by the polar about `inside` (E4), which is given. rows: of R^d, d >= 2, a1, .., ad, b
// row after row. Throws as vertices_of().
void add_vertices(std::size_t d, std::span<const Dyadic> rows, std::uint64_t most, PolytopeVertices& result);

}  // namespace sunder::polytope
