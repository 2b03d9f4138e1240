// Planes of space with exact coefficients, points that such planes cut out, and on which side of a plane these are.
// Also called: constructions in homogeneous coordinates; a side-of-plane predicate for a binary space partition.
#pragma once

#include <sunder/number/interval.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <cstddef>
#include <optional>

namespace sunder {

// A point with an enclosure of its coordinates, which decides most signs.
struct EnclosedPoint {
  ExactPoint3 exact;
  Vector3<Interval> about;

  EnclosedPoint() = default;
  explicit EnclosedPoint(ExactPoint3 p);  // the denominator may be negative; it is not zero
};

// The points x with normal . x = offset; above it is where normal . x is greater.
struct ExactPlane {
  Vector3<Dyadic> normal;
  Dyadic offset;
  Vector3<Interval> normal_about;
  Interval offset_about;

  ExactPlane(Vector3<Dyadic> given_normal, Dyadic given_offset);
  // The points whose coordinate on that axis is `at`: above is where it is greater.
  static ExactPlane across_axis(std::size_t axis, double at);
  // Through three points; above it they appear counter-clockwise. Its normal is zero if they are on one line, and of length
  // 1 if it is along an axis.
  static ExactPlane through(const Vector3<Dyadic>& p, const Vector3<Dyadic>& q, const Vector3<Dyadic>& r);

  bool has_no_normal() const;
  // The same plane in a frame that the map takes to the world.
  ExactPlane seen_from(const Affine3& frame) const;
  // positive: the point is above. Exact.
  Sign side_of(const EnclosedPoint& p, StageTally* tally = nullptr) const;
  // normal . x - offset, times the denominator of the point.
  Dyadic height(const ExactPoint3& p) const;
};

// The point in which the plane meets the segment from p to q. Requires that these are on different sides of it. Its
// numbers have about as many bits as the plane and both points together.
EnclosedPoint crossing_of(const ExactPlane& plane, const ExactPoint3& p, const ExactPoint3& q);

// The point that three planes have in common. Requires that there is one, and no other. Cramer's rule.
EnclosedPoint common_point(const ExactPlane& f, const ExactPlane& g, const ExactPlane& h);

// Enclosures of the same points, from enclosures of what makes them; nothing, where that tells none.
std::optional<Vector3<Interval>> crossing_about(const ExactPlane& plane, const Vector3<Interval>& p,
                                                const Vector3<Interval>& q);
std::optional<Vector3<Interval>> common_point_about(const ExactPlane& f, const ExactPlane& g, const ExactPlane& h);

}  // namespace sunder
