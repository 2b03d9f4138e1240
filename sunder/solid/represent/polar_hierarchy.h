// The hierarchy of the polar of a convex polyhedron P with an interior: by P's facets. What is left of a level are
// fewer half-spaces, and so a larger polyhedron around P; at the top it is a tetrahedron.
// Also called: outer hierarchy; dual Dobkin-Kirkpatrick hierarchy.
//
// Coordinates are those of P's frame about a point o inside P, with each axis multiplied by a power of two so that P is
// about 1 long along it, or longer where a coordinate would underflow; and where P is still thin, mapped so that it is
// round (round_frame.h). The facet n.y = h is the polar's vertex n / h.
//   Q1. Which triangles there are at every level is decided by exact signs of P's vertices; what is rounded is for
//       searches.
//   Q2. Four facets with a vertex of P in common are coplanar as points of the polar. The surface is triangulated
//       somehow: see hierarchy_builder.h.
//
// Source: BL15 section 5, preprocessing. Departure: the degrees of vertices that stay are not bounded
// (hierarchy_walk.h says why they need not be).
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/represent/bounded_hierarchy.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/round_frame.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunder::solid {

class ConvexPolyhedron;

struct PolarHierarchy {
  static constexpr std::size_t slot = 2;  // see solid/represent/of.h

  // Throws Error bad_shape where the dimension is not 3. Cost: O(n).
  static PolarHierarchy make(const ConvexPolyhedron& body);

  std::array<std::uint32_t, 4> base;  // o is the mean of these vertices of P
  Point3 to_one;                      // the powers of two
  RoundFrame to_round;                // what comes after them

  // By ranks of facets: `vertex` is the number of the facet, `at` the polar's vertex, rounded, and `middle` from o to
  // the mean of the facet's corners, rounded; no middle is a triangle.
  Hierarchy hierarchy;
};

// The same with bounded degrees (bounded_hierarchy.h). Facets of many corners are vertices of high degree, and are cut
// off: a cut point is a half-space between two facets, and holds the body.
struct BoundedPolarHierarchy {
  static constexpr std::size_t slot = 7;  // see solid/represent/of.h

  // Throws Error bad_shape where the dimension is not 3. Cost: O(n), and some exact arithmetic for each cut point.
  static BoundedPolarHierarchy make(const ConvexPolyhedron& body);

  std::array<std::uint32_t, 4> base;
  Point3 to_one;
  RoundFrame to_round;

  // By ranks of facets, as above; cut points rounded in the same frame.
  BoundedHierarchy hierarchy;
};

}  // namespace sunder::solid
