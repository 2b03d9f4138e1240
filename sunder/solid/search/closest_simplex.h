// The part of a simplex nearest to the origin, in floating point: the inner step of the Gilbert-Johnson-Keerthi
// search, in double or in double-double precision. Nothing here decides anything.
// Also called: distance subalgorithm of the GJK algorithm.
#pragma once

#include <sunder/solid/search/search_vector.h>

#include <array>
#include <cstdint>

namespace sunder::solid {

// A vertex of the difference A - B of two placed bodies: the image of vertex a minus that of vertex b, times the scale
// of the simplex, rounded.
template <class Real>
struct DifferenceVertexOf {
  VectorOf<Real> at;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};
using DifferenceVertex = DifferenceVertexOf<double>;

// Up to four difference vertices; the last is the newest.
template <class Real>
struct DifferenceSimplexOf {
  std::array<DifferenceVertexOf<Real>, 4> vertex;
  int count = 0;
  double scale = 1;  // a power of two
};
using DifferenceSimplex = DifferenceSimplexOf<double>;

// Replaces the simplex by its least face that holds the point nearest to the origin. Returns false when that is the
// whole tetrahedron, that is, when the origin is inside as far as floating point can tell. Else `towards` is a
// direction from the face to the origin: perpendicular to the face as well as floating point allows. Requires a
// vertex; and the part without the newest vertex must have been the closest one before, as it is when the search goes
// from there towards the origin.
// Source: Ericson 2005, section 5.1 (regions of a triangle and a tetrahedron).
// `distance2` is the square of the face's distance from the origin.
template <class Real>
bool reduce_to_closest_face(DifferenceSimplexOf<Real>& simplex, VectorOf<Real>& towards, Real& distance2);

// The weights, up to a factor, of the point of the simplex that is nearest to the origin. The simplex must be the least
// face that holds it.
template <class Real>
std::array<Real, 4> weights_of_nearest(const DifferenceSimplexOf<Real>& simplex);

// The weights of the origin in a tetrahedron that holds it, up to a factor.
template <class Real>
std::array<Real, 4> weights_of_origin(const DifferenceSimplexOf<Real>& tetrahedron);

}  // namespace sunder::solid
