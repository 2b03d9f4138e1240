// Lines, rays and half-planes of the plane, by two points of theirs. (Segments are in segments.h.)
// Also called: half-lines; half-spaces of the plane.
//
// Plain numbers; what the factories give has finite coordinates and two different points, as every question about them
// requires. The points are the line, exactly: a line through two points that were rounded is the line through these.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>

#include <cmath>

namespace sunder::planar {

namespace line_detail {

// Throws Error bad_value where a coordinate is not finite, bad_shape where the points are equal (-0 equals 0).
inline void require_direction(const Point2& a, const Point2& b, const char* what) {
  for (const double x : {a.x, a.y, b.x, b.y}) {
    if (!std::isfinite(x)) throw Error(ErrorCode::bad_value, "a coordinate is not finite; give finite numbers", what);
  }
  if (a == b) throw Error(ErrorCode::bad_shape, "its two points are equal; give two different ones", what);
}

}  // namespace line_detail

// The line through a and b, with the direction from a to b.
struct Line {
  Point2 a, b;
  friend bool operator==(const Line&, const Line&) = default;

  // Throws Error bad_value where a coordinate is not finite, bad_shape where the points are equal.
  static Line through(const Point2& a, const Point2& b) {
    line_detail::require_direction(a, b, "line");
    return {a, b};
  }
};

// The points of the line from a on, in the direction of b; a is one of them.
struct Ray {
  Point2 a, b;
  friend bool operator==(const Ray&, const Ray&) = default;

  // Throws as Line::through.
  static Ray from(const Point2& a, const Point2& through) {
    line_detail::require_direction(a, through, "ray");
    return {a, through};
  }
};

// The points to the left of the line from a to b, and those on it.
struct HalfPlane {
  Point2 a, b;
  friend bool operator==(const HalfPlane&, const HalfPlane&) = default;

  // Throws as Line::through.
  static HalfPlane left_of(const Point2& a, const Point2& b) {
    line_detail::require_direction(a, b, "half-plane");
    return {a, b};
  }
};

}  // namespace sunder::planar
