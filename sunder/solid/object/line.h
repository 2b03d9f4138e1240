// Lines, rays and segments of space, by two points of theirs.
// Also called: half-lines; line segments, edges.
//
// Plain numbers; what the factories give has finite coordinates and, but for a segment, two different points, as every
// question about them requires. The points are the line, exactly.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>

#include <cmath>

namespace sunder::solid {

namespace line_detail {

// Throws Error bad_value where a coordinate is not finite.
inline void require_finite(const Point3& a, const Point3& b, const char* what) {
  for (const double x : {a.x, a.y, a.z, b.x, b.y, b.z}) {
    if (!std::isfinite(x)) throw Error(ErrorCode::bad_value, "a coordinate is not finite; give finite numbers", what);
  }
}
// And bad_shape where the points are equal (-0 equals 0).
inline void require_direction(const Point3& a, const Point3& b, const char* what) {
  require_finite(a, b, what);
  if (a == b) throw Error(ErrorCode::bad_shape, "its two points are equal; give two different ones", what);
}

}  // namespace line_detail

// The line through a and b, with the direction from a to b.
struct Line {
  Point3 a, b;
  friend bool operator==(const Line&, const Line&) = default;

  // Throws Error bad_value where a coordinate is not finite, bad_shape where the points are equal.
  static Line through(const Point3& a, const Point3& b) {
    line_detail::require_direction(a, b, "line");
    return {a, b};
  }
};

// The points of the line from a on, in the direction of b; a is one of them.
struct Ray {
  Point3 a, b;
  friend bool operator==(const Ray&, const Ray&) = default;

  // Throws as Line::through.
  static Ray from(const Point3& a, const Point3& through) {
    line_detail::require_direction(a, through, "ray");
    return {a, through};
  }
};

// The points from a to b, which may be one point.
struct Segment {
  Point3 a, b;
  friend bool operator==(const Segment&, const Segment&) = default;

  // Throws Error bad_value where a coordinate is not finite.
  static Segment between(const Point3& a, const Point3& b) {
    line_detail::require_finite(a, b, "segment");
    return {a, b};
  }
};

}  // namespace sunder::solid
