// The part of a simplex nearest to the origin, in floating point: the inner step of the Gilbert-Johnson-Keerthi
// search. Nothing here decides anything.
#pragma once

#include <sunder/predicate/point.h>

#include <array>
#include <cstdint>

namespace sunder::solid {

// A vertex of the difference A - B of two placed bodies: the image of vertex a minus that of vertex b, times the scale
// of the simplex, rounded.
struct DifferenceVertex {
  Point3 at;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

// One to four difference vertices; the last is the newest.
struct DifferenceSimplex {
  std::array<DifferenceVertex, 4> vertex;
  int count = 0;
  double scale = 1;  // a power of two
};

// Replaces the simplex by its least face that holds the point nearest to the origin. Returns false when that is the
// whole tetrahedron, that is, when the origin is inside as far as floating point can tell. Else `towards` is a
// direction from the face to the origin: perpendicular to the face as well as floating point allows. Of a tetrahedron,
// the face without the newest vertex must have been the closest one before.
// Source: Ericson 2005, section 5.1 (regions of a triangle and a tetrahedron).
// `distance2` is the square of the face's distance from the origin.
bool reduce_to_closest_face(DifferenceSimplex& simplex, Point3& towards, double& distance2);

// The weights of the origin in a tetrahedron that holds it, up to a factor.
std::array<double, 4> weights_of_origin(const DifferenceSimplex& tetrahedron);

}  // namespace sunder::solid
