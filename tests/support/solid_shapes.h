// Families of points whose hulls are hard for something: vertices of huge degree, facets of huge size, facets that are
// nearly coplanar, facets that are. From a seed; without GoogleTest, so that benchmarks use them too.
#pragma once

#include <sunder/base/random.h>
#include <sunder/predicate/point.h>

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace sunder::tests {

// n points each, all of them vertices of their hull, for n from 8 to 2^17.
namespace solid_shapes {

std::vector<Point3> sphere(std::size_t n, Random& random);
std::vector<Point3> bipyramid(std::size_t n);  // two apices over and under a polygon
std::vector<Point3> prism(std::size_t n);  // two polygons one above the other, exactly; for an odd n one point fewer
std::vector<Point3> cone(std::size_t n);   // an apex over a polygon
std::vector<Point3> wedge(std::size_t n);  // two apices joined by an edge, over an arc: the two join everything

// A trough whose floor is a parabola, extended: the slopes of neighbouring facets differ by 2^-50, exactly, and half of
// the vertices are in one plane. For an odd n one point fewer.
std::vector<Point3> chain(std::size_t n);

// (t, t^2, t^3), without rounding: the first and the last point join everything.
std::vector<Point3> moment_curve(std::size_t n);
// (cos t, sin t, t) over nine tenths of a turn: the same, as far as rounding lets it be.
std::vector<Point3> helix(std::size_t n);
// (cos t, sin t, cos 2 t): ruled by edges, so that it is all quadrangles which rounding makes nearly flat.
std::vector<Point3> saddle(std::size_t n);

// A tetrahedron; in each round every facet at its first vertex gets a vertex above it, which sees no other facet, so
// that the degree of the first doubles. The last round may be a part of one.
// Source: Barba, Langerman 2015, section 4. Departures: the new vertices lie on a circular cone with the first as its
// apex, nearer to it from round to round, as a factor of 1.2. So they stay vertices in doubles, for 2^20 of them.
std::vector<Point3> stacked(std::size_t n);

std::vector<Point3> flat(std::size_t n);                    // a polygon in the plane x = z
std::vector<Point3> needle(std::size_t n, Random& random);  // a sphere stretched as 1e300 : 1 : 1e-300

// All points of a cubical grid of at most n points, of which 8 are vertices.
std::vector<Point3> grid(std::size_t n);

}  // namespace solid_shapes

struct SolidShape {
  std::string_view name;
  std::vector<Point3> (*make)(std::size_t n, Random& random);
  std::size_t (*vertex_count)(std::size_t n);
  std::size_t (*greatest_degree)(std::size_t n);  // nullptr: it is not known, but small
};

// All of them.
std::span<const SolidShape> all_solid_shapes();

}  // namespace sunder::tests
