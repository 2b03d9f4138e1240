// On which side: the orientation predicates, exact for every finite double, for points and for posed points.
// Also called: orientation predicate; counter-clockwise test (CCW); side of a line or plane.
//
// Each runs in stages: floating point with a derived error bound, intervals (of posed points in space double-doubles,
// too, which are tallied as intervals), exact numbers. All stages evaluate one formula. Where a tally is given, the stage
// that decided is counted in it.
// Sources: Shewchuk 1997 for the idea of adaptive signs; the bounds are derived in number/rounded.h.
#pragma once

#include <sunder/number/rounded.h>
#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <cmath>

namespace sunder {

// positive: a, b, c turn counter-clockwise (left); zero: collinear; negative: clockwise.
// Formula: (b - a) x (c - a). Exchanging two points flips the sign.
// Where two of the points are equal it is zero at once.
inline Sign orient_2d(const Point2& a, const Point2& b, const Point2& c, StageTally* tally = nullptr);

// The same for points of space projected along an axis (0: x, 1: y, 2: z) on the plane of the other two in cyclic
// order (for axis 2: x, y).
Sign orient_2d_along(int axis, const Point3& a, const Point3& b, const Point3& c, StageTally* tally = nullptr);
Sign orient_2d_along(int axis, const Posed3& a, const Posed3& b, const Posed3& c, StageTally* tally = nullptr);

// positive: d is on the side of the plane a, b, c to which (b - a) x (c - a) points, that is, a, b, c appear
// counter-clockwise from d; zero: coplanar; negative: on the other side.
// Formula: ((b - a) x (c - a)) . (d - a). Exchanging two points flips the sign.
// (Shewchuk's orient3d has the opposite sign: mind it when comparing.)
Sign orient_3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d, StageTally* tally = nullptr);
Sign orient_3d(const Posed3& a, const Posed3& b, const Posed3& c, const Posed3& d, StageTally* tally = nullptr);
Sign orient_3d(const Posed3& a, const Posed3& b, const Posed3& c, const Point3& d, StageTally* tally = nullptr);
Sign orient_3d(const Point3& a, const Point3& b, const Posed3& c, const Posed3& d, StageTally* tally = nullptr);

// Are they on one line? By orient_2d along the axes, up to the first that is not zero.
bool are_collinear(const Point3& a, const Point3& b, const Point3& c, StageTally* tally = nullptr);
bool are_collinear(const Point3& a, const Point3& b, const Posed3& c, StageTally* tally = nullptr);

// The sign of b's coordinate minus a's (axis 0: x, 1: y, 2: z).
Sign compare_coordinate(int axis, const Posed3& a, const Posed3& b, StageTally* tally = nullptr);

// What its first stage leaves: exact products where the differences are doubles (tallied as rounded); else as the rest.
Sign orient_2d_further(const Point2& a, const Point2& b, const Point2& c, StageTally* tally);

// The first stage: the formula as a Rounded<4>, whose magnitude is the sum of the two products' sizes. Differences of
// doubles never underflow; a product that does is off by at most 2^-1075, which the last term pays for many times over.
// Overflow makes the error infinite or the comparisons false.
struct RoundedOrientation {
  double value, error;
  RoundedOrientation(const Point2& a, const Point2& b, const Point2& c) {
    const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
    value = left - right;
    error = Rounded<4>::bound * (std::fabs(left) + std::fabs(right)) + 0x1p-1060;
  }
  bool is_sure() const { return value > error || value < -error; }
};

inline Sign orient_2d(const Point2& a, const Point2& b, const Point2& c, StageTally* tally) {
  const RoundedOrientation rounded(a, b, c);
  if (rounded.is_sure() || a == c || b == c || a == b) {
    return counted(&StageTally::rounded, tally,
                   rounded.value > rounded.error    ? Sign::positive
                   : rounded.value < -rounded.error ? Sign::negative
                                                    : Sign::zero);
  }
  return orient_2d_further(a, b, c, tally);
}

// Do the segments ab and cd cross in an inner point of both? positive: surely; negative: surely they do not even meet;
// else unsure. By the first stage of the four orientations, without branches.
inline Guess surely_cross_2d(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const RoundedOrientation of_c(a, b, c), of_d(a, b, d), of_a(c, d, a), of_b(c, d, b);
  const auto is_sure = [](const RoundedOrientation& o) { return static_cast<int>(std::fabs(o.value) > o.error); };
  if ((is_sure(of_c) & is_sure(of_d) & is_sure(of_a) & is_sure(of_b)) == 0) return Guess::unsure;
  const bool cross = ((of_c.value > 0) != (of_d.value > 0)) & ((of_a.value > 0) != (of_b.value > 0));
  return cross ? Guess::positive : Guess::negative;
}

// The sign of the determinant of the 3 x 3 matrix of a pose, row by row.
Sign determinant_sign(const Affine3& pose);

}  // namespace sunder
