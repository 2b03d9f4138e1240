// The polar of a convex polyhedron P with an interior, about a point o inside: all y with y.(x - o) <= 1 for every x
// of P. Facets become vertices, and vertices become facets: the facet in the plane n.(x - o) = h, h > 0, becomes the
// vertex n / h; the vertex v becomes the facet in the plane (v - o).y = 1; edges become edges.
// Also called: polar dual, polar body, reciprocal polyhedron, polarization.
//
// P1. Which vertices, edges and facets the polar has, and in what order, is carried over from the polyhedron and never
//     computed from coordinates. Facets of P are maximal, so vertices of the polar are distinct, and its facets too.
// P2. o is the mean of four vertices that are no plane's, exactly: so it is inside.
// P3. Coordinates are doubles, for searches; exact_polar_vertex has the exact ones. Where doubles cannot tell the
//     vertex to about 30 bits, it is rounded from the exact one. Beyond the range of doubles (of bodies smaller than
//     1e-308, or of facets that are nearer to o) it is infinite.
// P4. What one might assume and does not hold: a vertex of the polar may have any degree, for P's facets may have any
//     number of vertices.
//
// Source: BL15 section 3, the polar that contains the origin (rho with a zero), moved to o; that it is one of P's is
// Lemma 3.2. Its lemmas and Theorem 3.7 are tested in tests/solid/polar_property_test.cpp.
#pragma once

#include <sunder/base/error.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/estimate.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

class ConvexPolyhedron;

struct Polar {
  static constexpr std::size_t slot = 1;  // see solid/represent/of.h

  // Throws Error bad_shape where the dimension is not 3. Cost: O(n); no sign of coordinates is asked for. With V
  // vertices, F facets and E edges: 36 F + 4 V + 16 E bytes, which is 62 for each vertex of the polar where all facets
  // of P are triangles. Rounding from exact numbers is some twenty times slower: where a body is a needle, all of it.
  static Polar make(const ConvexPolyhedron& body);

  std::array<std::uint32_t, 4> base;  // o is the mean of these vertices of P
  Point3 center;                      // o, rounded

  // By P's facets, as seen from o: n / h; and how far their coordinates may be off.
  std::vector<Point3> vertices;
  std::vector<double> errors;

  // The other ends of the edges at vertex f, counter-clockwise seen from outside of the polar: the numbers
  // neighbours[edge_begin[f] .. edge_begin[f + 1]). The j-th is across the edge of P's facet f from its j-th vertex to
  // the next one. So that facet of P is also the cycle of the polar's facets at the vertex.
  std::vector<std::uint32_t> edge_begin;
  std::vector<std::uint32_t> neighbours;

  // By P's vertices: the polar's facet v has the vertices facet_vertices[facet_begin[v] .. facet_begin[v + 1]),
  // counter-clockwise seen from outside of the polar.
  std::vector<std::uint32_t> facet_begin;
  std::vector<std::uint32_t> facet_vertices;

  std::size_t memory() const;  // bytes
};

// The point n / h, as seen from o: h is positive. Times 4 each, so that all of it is made of differences.
template <class T>
struct PolarVertexOf {
  std::array<T, 3> n;
  T h;
};
using PolarVertex = PolarVertexOf<Dyadic>;  // exactly

// The same of a body whose vertices were moved. Requires that its facets bound their hull still, as when each axis is
// multiplied by a positive number.
Polar make_polar(const ConvexPolyhedron& body, std::span<const Point3> vertices);

// The polar's vertex of one facet of P, given as its cycle of vertex numbers. Requires three of them or more; `base`
// is the polar's.
PolarVertex exact_polar_vertex(std::span<const Point3> vertices, std::span<const std::uint32_t> facet,
                               const std::array<std::uint32_t, 4>& base);

// The same with a bound of the error.
PolarVertexOf<Estimate> estimated_polar_vertex(std::span<const Point3> vertices, std::span<const std::uint32_t> facet,
                                               const std::array<std::uint32_t, 4>& base);

}  // namespace sunder::solid
