// The vertices of a bounded polytope that is given by half-spaces, as fractions: by the polar, whose facets they are,
// or as the rays of a cone.
// Also called: H-to-V conversion; vertex enumeration; half-space intersection; dual hull.
#pragma once

#include <sunder/base/error.h>
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/object/polytope.h>

#include <cstdint>
#include <vector>

namespace sunder::polytope {

// E1. vertices: exactly those of the common part, each once. Of each d + 1 numbers, of which the last, w, is positive:
//     it is x1 / w, .., xd / w.
// E2. bounding: exactly the half-spaces whose boundary has a facet of the common part, ascending; of such that are the
//     same but for a factor, one.
// E3. at[k]: those of `bounding` whose boundary holds vertex k, ascending: d at least. Vertices are in the
// lexicographic
//     order of these.
// E4. inside: a point x / w likewise, strictly inside of all half-spaces, but of 0 x <= 0, which are all of space.
// E5. fans[k]: d at a time, some of at[k] whose normals are independent. The cones of these normals cut the cone of all
//     directions along which vertex k is furthest; those of all vertices are a triangulation of all directions: each
//     d - 1 of a cone are those of one other, too, on the other side.
struct PolytopeVertices {
  std::vector<std::vector<Dyadic>> vertices;
  std::vector<std::uint32_t> bounding;
  std::vector<std::vector<std::uint32_t>> at, fans;
  std::vector<Dyadic> inside;
  // What the way to the vertices cost that came to its end: as of ConvexHull, of the polar; or rays compared with
  // half-spaces, and of these those in integers beyond one word.
  std::uint64_t side_tests = 0, exact_tests = 0;
};

// A point strictly inside of all half-spaces (E4), as d + 1 numbers as above; nothing where there is none. Where the
// common part is not bounded, it may say so instead: then the last number is zero, and the others are a direction that
// goes on strictly inside of all. By linear programming in integers (pair/phase_one_internal.h): multipliers m >= 0,
// not all zero, with sum m_i a_i = 0 and sum m_i b_i <= 0 are what a point inside contradicts, and the other way round.
std::vector<Dyadic> point_inside(const Polytope& half_spaces);

// Requires half-spaces. Throws Error bad_shape where their common part is empty, is not bounded, or has no inside (lies
// in a hyperplane); and as convex_hull(), where the polar has too many simplices. Cost: that of point_inside(), and of
// the hull of n points with as many facets as there are vertices; where many half-spaces end in each vertex, of a
// double description (double_description_internal.h).
PolytopeVertices vertices_of(const Polytope& half_spaces, std::uint64_t most = most_simplices);

}  // namespace sunder::polytope
