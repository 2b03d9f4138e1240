// A plane of space, by a normal and a point, or a normal and an offset.
// Also called: hyperplane; half-space boundary; cutting plane, section plane.
//
// Plain numbers; what the factories give is finite, with a normal that is not zero, as every question about it
// requires. The numbers are the plane, exactly; the normal need not have length 1.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>

#include <cmath>

namespace sunder::solid {

// The points x with normal . (x - point) = offset; those with more than the offset are above it.
struct Plane {
  Point3 normal;
  Point3 point{};
  double offset = 0;
  friend bool operator==(const Plane&, const Plane&) = default;

  // The plane through a point. Throws Error: bad_value where a number is not finite, bad_shape for a zero normal.
  static Plane through(const Point3& point, const Point3& normal) { return checked({normal, point, 0}); }

  // The points x with normal . x = offset. Throws as through().
  static Plane at(const Point3& normal, double offset) { return checked({normal, {}, offset}); }

 private:
  static Plane checked(const Plane& plane) {
    for (const double x :
         {plane.normal.x, plane.normal.y, plane.normal.z, plane.point.x, plane.point.y, plane.point.z, plane.offset}) {
      if (!std::isfinite(x)) throw Error(ErrorCode::bad_value, "a number is not finite; give finite numbers", "plane");
    }
    if (plane.normal == Point3{}) {
      throw Error(ErrorCode::bad_shape, "its normal is zero; give a direction across the plane", "plane");
    }
    return plane;
  }
};

}  // namespace sunder::solid
