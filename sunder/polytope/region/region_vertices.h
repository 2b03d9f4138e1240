// The vertices of the common part of half-spaces of R^d, 2 <= d <= 6, whatever it is: also where it lies in a flat, or
// is a point; else that it is empty, or not bounded. Of bounded half-spaces with a common inside alone:
// hull/vertices.h. Also called: vertex enumeration; H-to-V conversion; half-space intersection.
#pragma once

#include <sunder/base/error.h>
#include <sunder/polytope/hull/vertices.h>
#include <sunder/polytope/region/half_space_region.h>

#include <cstdint>

namespace sunder::polytope {

// V1. region: what the common part is, with evidence that check() accepts.
// V2. bounded: found.vertices, as E1. Of a common part of k < d dimensions `bounding` are the half-spaces that bound it
//     in the flat that it spans (E2, E3 hold of the flat: vertices are on k of them at least; where k is 0 there are
//     none), and `inside` is inside of these.
// V3. bounded: found.fans, as E5, of normals in R^d: of a flat part each cone has k half-spaces of at[k], and d - k of
//     those whose multipliers are `flat`.
// Not bounded: found is empty.
struct [[nodiscard]] RegionVertices {
  HalfSpaceRegion region;
  PolytopeVertices found;
};

// Requires half-spaces. Throws Error bad_shape where the polar has more than `most` simplices. Cost: that of
// half_space_region(), and of vertices_of(), in exact numbers where the common part is flat.
RegionVertices region_vertices(const Polytope& half_spaces, std::uint64_t most = most_simplices);

}  // namespace sunder::polytope
