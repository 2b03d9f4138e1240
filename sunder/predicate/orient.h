// On which side: the orientation predicates, exact for every finite double.
//
// Each runs in stages: floating point with a derived error bound, intervals, exact. All stages evaluate one formula.
// Sources: Shewchuk 1997 for the idea of adaptive signs; the bounds are derived in number/rounded.h.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>

namespace sunder {

// positive: a, b, c turn counter-clockwise (left); zero: collinear; negative: clockwise.
// Formula: (b - a) x (c - a). Exchanging two points flips the sign.
Sign orient_2d(const Point2& a, const Point2& b, const Point2& c);

// The same for points of space projected along an axis (0: x, 1: y, 2: z) on the plane of the other two in cyclic
// order (for axis 2: x, y).
Sign orient_2d_along(int axis, const Point3& a, const Point3& b, const Point3& c);

// positive: d is on the side of the plane a, b, c to which (b - a) x (c - a) points, that is, a, b, c appear
// counter-clockwise from d; zero: coplanar; negative: on the other side.
// Formula: ((b - a) x (c - a)) . (d - a). Exchanging two points flips the sign.
// (Shewchuk's orient3d and CGAL's orientation have the opposite or the same sign: mind it when comparing.)
Sign orient_3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

}  // namespace sunder
