// orient_3d for points whose coordinates, or whose distances, may be of very different sizes: as those that crowd
// together at a point, or lie along axes that are scaled apart.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>

namespace sunder {

// As orient_3d, exactly. Before intervals and exact numbers the formula is tried in floating point from each of the
// four points, with axes and differences times powers of two, so that nothing overflows and what underflows is below
// the error.
Sign orient_3d_of_any_size(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

// What floating point says of it; for tests.
Guess scaled_orient_3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

}  // namespace sunder
