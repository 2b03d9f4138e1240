// Triangulations of the facets of a polytope, from nothing but the vertices that each has.
// Also called: pulling triangulation.
#pragma once

#include <sunder/polytope/hull/bits.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::polytope {

// The facets of a polytope of d dimensions, each as the set of its vertices; next[f]: the facets that have a ridge in
// common with f, others than these do no harm. Of each facet the simplices, d vertices each: each face is cut into the
// cones from its least vertex over those of its own facets that are without it. So neighbours cut what they have in
// common in the same way, and all together are a triangulation of the boundary. At most `most` simplices; false where
// there are more. Cost: in each face, the intersections of each two of its facets.
// Source: Hudson 1969; Lee 1991.
bool pulled_simplices(std::size_t d, std::span<const Bits> facets, std::span<const std::vector<std::uint32_t>> next,
                      std::uint64_t most, std::vector<std::vector<std::uint32_t>>& simplices);

}  // namespace sunder::polytope
