// The convex hull of any finite set of points of space, exactly, flat and degenerate sets too.
// Also called: convex hull in three dimensions; quickhull.
#pragma once

#include <sunder/base/error.h>
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
// H3. Facets are maximal: what lies in one plane is one facet. Facet f is the cycle of vertex numbers (positions in
//     `vertices`, not input indices) facet_vertices[facet_begin[f] .. facet_begin[f + 1]), counter-clockwise from
//     outside, starting at its lowest vertex number. Any three consecutive vertices of a facet turn strictly left.
//     Dimension 2: two facets, the polygon and its reverse. Dimensions 0 and 1: none.
// H4. neighbours[neighbour_begin[v] .. neighbour_begin[v + 1]): the other ends of the edges at vertex v, as vertex
//     numbers, counter-clockwise from outside, starting at the lowest. Dimension 2: two, dimension 1: one,
//     dimension 0: none. Edges are those between two facets: no edge ends inside another.
// H5. Facets are ordered by their vertex cycles lexicographically. So the result depends on the points and their order
//     in the input only, never on the order in which the algorithm went.
// What one might assume and does not hold: facets need not be triangles, and a scaling or rotation that rounds
// coordinates may change everything.
struct ConvexHull {
  int dimension = 0;
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> facet_begin{0};
  std::vector<std::uint32_t> facet_vertices;
  std::vector<std::uint32_t> neighbour_begin{0};
  std::vector<std::uint32_t> neighbours;
  std::uint64_t side_tests = 0;  // what it cost: how many times a point was compared with a plane; 3 dimensions only
};

// Requires nothing of the points: any may be equal, collinear, coplanar, cospherical, or of any size.
// Throws Error: bad_shape when there is no point (or 2^29 or more: the counts in ConvexHull are up to 6 per point),
// bad_value naming the first point with a NaN or infinite coordinate ("point 7").
// Cost: O(n log n) side tests on all families of tests/support/solid_shapes.h, vertices of degree n among them, and of
// points that crowd together geometrically (tests/solid/solid_hull_complexity_test.cpp); no proof that it is so on
// every input. Every side test is decided exactly, in floating point where that can tell, at all sizes of coordinates;
// coplanar points cost more, and so do some that lie next to each other with coordinates of very different size (1e-300
// beside 1e300). Source: Barber, Dobkin, Huhdanpaa 1996 (Quickhull). Departures: signs are exact, so facets are merged
// in the end because they are coplanar, and never because they nearly are; the proofs that this needs are in
// quickhull.cpp.
ConvexHull convex_hull(std::span<const Point3> points);

}  // namespace sunder::solid
