// The convex hull of any finite set of points of space, exactly, flat and degenerate sets too.
#pragma once

#include <sunder/predicate/point.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

// The hull as combinatorial structure over the input points.
//
// H1. vertices: exactly the extreme points of the set, each once (of equal points the one with the lowest index),
//     as indices into the input, in increasing order. A point inside a facet or an edge is no vertex.
// H2. dimension: that of the affine hull: 0 one point, 1 a segment (2 vertices), 2 a polygon, 3 a body.
// H3. Facets are maximal: coplanar triangles are merged. Facet f is the cycle of vertex numbers (positions in
//     `vertices`, not input indices) facet_vertices[facet_begin[f] .. facet_begin[f + 1]), counter-clockwise from
//     outside, starting at its lowest vertex number. Any three consecutive vertices of a facet turn strictly left.
//     Dimension 2: two facets, the polygon and its reverse. Dimensions 0 and 1: none.
// H4. neighbours[neighbour_begin[v] .. neighbour_begin[v + 1]): the other ends of the edges at vertex v,
//     counter-clockwise from outside, starting at the lowest. Dimension 2: two, dimension 1: one, dimension 0: none.
// H5. Facets are ordered by their vertex cycles lexicographically. So the result depends on the set of points and
//     their order in the input only, never on the order in which the algorithm went.
struct ConvexHull {
  int dimension = 0;
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> facet_begin{0};
  std::vector<std::uint32_t> facet_vertices;
  std::vector<std::uint32_t> neighbour_begin{0};
  std::vector<std::uint32_t> neighbours;
};

// Throws Error: bad_shape when there is no point (or 2^31 or more), bad_value naming the first point with a NaN or
// infinite coordinate.
// Cost: O(n log n) expected on inputs seen in practice, O(n^2) at worst.
// Source: Barber, Dobkin, Huhdanpaa 1996 (Quickhull); departures: exact signs, facets coplanar with the new point
// are removed with the visible ones so that no flat triangle ever arises.
ConvexHull convex_hull(std::span<const Point3> points);

}  // namespace sunder::solid
