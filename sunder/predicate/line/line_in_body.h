// A line of the world seen from the frame of a posed body, exactly: there the body's vertices are plain doubles. Where
// it meets planes of the body, and how rays from a point inside to such places lie among the vertices.
// Also called: pulled-back line; line-plane intersection.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/interval.h>
#include <sunder/number/sign.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <array>

namespace sunder {

// Places on it are points in the body's frame; one with denominator zero is a direction, in which the line comes from
// afar.
class LineInBody {
 public:
  // The line through a and b. Requires an invertible pose and two different points. Cost: exact arithmetic.
  LineInBody(const Point3& a, const Point3& b, const Affine3& pose);

  // The sign of N.d, N = (v - u) x (w - u), d from a to b.
  Sign facing(const Point3& u, const Point3& v, const Point3& w, StageTally* tally = nullptr) const;

  // Where it meets the plane of u, v and w. Requires that it is not parallel to that.
  ExactPoint3 at_plane(const Point3& u, const Point3& v, const Point3& w) const;

  // The image of a + t (b - a).
  ExactPoint3 at(const ExactFraction& t) const;

  // Where all of it comes from: the direction from b to a.
  ExactPoint3 from_afar() const;

  // In the middle of two of its points.
  static ExactPoint3 between(const ExactPoint3& p, const ExactPoint3& q);

 private:
  Vector3<Dyadic> point_, way_;  // (point + t way) / scale is the image of a + t (b - a)
  Dyadic scale_;                 // positive
  Vector3<Interval> way_in_;     // up to a power of two
};

// The sign of N.(p - u), N as above. Requires a point.
Sign side_of_plane(const Point3& u, const Point3& v, const Point3& w, const ExactPoint3& p,
                   StageTally* tally = nullptr);

// From the mean o of four points to a place on a line.
class WayFromMiddle {
 public:
  WayFromMiddle(const std::array<Point3, 4>& of, const ExactPoint3& to);

  // The sign of the determinant of p - o, q - o and the way.
  Sign turn(const Point3& p, const Point3& q, StageTally* tally = nullptr) const;

 private:
  std::array<Point3, 4> middle_of_;
  Vector3<Dyadic> way_;
  Vector3<Interval> way_in_;  // up to a power of two
};

}  // namespace sunder
