// The convex hull of any finite set of points of R^d, 2 <= d <= 6, exactly: its vertices and its facets, also where it
// has fewer dimensions. In space, where facets are polygons, solid/hull/convex_hull.h is the front door.
// Also called: V-to-H conversion; vertex and facet enumeration; quickhull.
#pragma once

#include <sunder/base/error.h>
#include <sunder/number/dyadic.h>
#include <sunder/polytope/object/polytope.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::polytope {

// The hull as combinatorial structure over the input points; all numbers of points are their indices there.
//
// C1. dimension: k, that of the affine hull: 0 one point, 1 a segment, .., d.
// C2. vertices: exactly the extreme points, each once (of equal points the first), ascending. k = 1: two. k = 0: one.
// C3. Facets are maximal: what lies in one hyperplane (of the flat, where k < d) is one facet. facet_vertices(f): all
//     vertices on it, ascending. Facets are in the lexicographic order of these. k = 1: each vertex is one. k = 0:
//     none.
// C4. simplices(f): a triangulation of the facet, without further vertices: simplex after simplex, k corners each. All
//     together they are one of the boundary: each k - 1 corners of a simplex are those of one other simplex, too.
//     k > 1: corners are ordered so that det(q - p0, p1 - p0, ..) is positive just where q is strictly beyond the
//     facet; components are those of `columns`.
// C5. columns: k coordinates, ascending, that tell the others of all points: those of the flat.
// What one might assume and does not hold: which triangulation it is depends on the order of the points.
struct ConvexHull {
  std::size_t space = 0, dimension = 0;  // d, k
  std::vector<std::size_t> columns;
  std::vector<std::uint32_t> vertices;
  std::vector<std::size_t> facet_begin{0};    // facet f: vertices[facet_begin[f]] to [facet_begin[f + 1]] of
  std::vector<std::uint32_t> facet_corners;   // this list
  std::vector<std::size_t> simplex_begin{0};  // likewise, in simplices, of k entries each
  std::vector<std::uint32_t> simplex_corners;
  std::uint64_t side_tests = 0, exact_tests = 0;  // what it cost: points compared with planes; of these, exactly

  std::size_t facet_count() const { return facet_begin.size() - 1; }
  std::size_t simplex_count() const { return simplex_begin.back(); }
  std::span<const std::uint32_t> facet_vertices(std::size_t f) const {
    return std::span(facet_corners).subspan(facet_begin[f], facet_begin[f + 1] - facet_begin[f]);
  }
  std::span<const std::uint32_t> simplices(std::size_t f) const {
    return std::span(simplex_corners)
        .subspan(simplex_begin[f] * dimension, (simplex_begin[f + 1] - simplex_begin[f]) * dimension);
  }
};

// Simplices that may be held at once: some 200 bytes each.
inline constexpr std::uint64_t most_simplices = 4'000'000;

// Requires points, not half-spaces. Nothing is required of their position.
// Throws Error bad_shape where more than `most` simplices would be held at once: n points can have some n^floor(d/2)
// facets. Cost: of n points and F simplices some n + F, times logarithms, on points at random; exact arithmetic where
// points are nearly in a plane, and not where coordinates have few bits (grids). Flat sets: all points exactly, once.
// Source: Barber, Dobkin, Huhdanpaa 1996; departures in quickhull.h.
ConvexHull convex_hull(const Polytope& points, std::uint64_t most = most_simplices);

// The facet as a half-space of R^d that holds all points: a1, .., ad, b with a x <= b, and a x = b just on the facet
// (of the hull). Exact; a is not zero. One of k < d has many; this one's a is zero but in `columns`.
std::vector<Dyadic> facet_half_space(const ConvexHull& hull, const Polytope& points, std::size_t f);

// The flat that the hull spans, as d - k equations: a1, .., ad, b with a x = b for all points. Exact.
std::vector<std::vector<Dyadic>> flat_equations(const ConvexHull& hull, const Polytope& points);

}  // namespace sunder::polytope
