// Arrows of the plane, from one point to another: which way is one against the other? Exact, for every finite double.
// Also called: signs of cross and dot products of vectors; left turn, right turn.
//
// Points are plain (Point2) or under poses (Posed2, whose exact images are meant); all four of one kind.
#pragma once

#include <sunder/number/rounded.h>
#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <algorithm>
#include <cmath>

namespace sunder {

// positive: the arrow rs points to the left of the arrow pq; zero: they are parallel, or one is a point; negative: to
// the right. Formula: (q - p) x (s - r). With r = p: the orientation of p, q, s.
inline Sign cross_2d(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally = nullptr);
inline Sign cross_2d(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally = nullptr);

// positive: the arrow rs points along the arrow pq, less than a right angle away; zero: they are perpendicular, or one
// is a point; negative: it points against it. Formula: (q - p) . (s - r).
inline Sign dot_2d(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally = nullptr);
inline Sign dot_2d(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally = nullptr);

// What their first stages do not decide.
Sign cross_2d_further(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally);
Sign dot_2d_further(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally);
Sign cross_2d_further(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally);
Sign dot_2d_further(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally);

// The sign of a b + c d for differences a, b, c, d of doubles, rounded: the first stage. As a Rounded<4>, whose
// magnitude is the sum of the products' sizes. Differences of doubles never underflow, and are zero only where exact
// ones are: so a product with such a factor is exactly zero, and the sign of a single product that is left is sure. A
// product that underflows is off by at most 2^-1075, which the last term pays for many times over. Overflow makes the
// error infinite or the comparisons false.
inline Guess sign_of_products(double a, double b, double c, double d) {
  const double left = a * b, right = c * d, value = left + right;
  const double error = Rounded<4>::bound * (std::fabs(left) + std::fabs(right)) + 0x1p-1060;
  if (value > error) return Guess::positive;
  if (value < -error) return Guess::negative;
  const bool no_left = a == 0 || b == 0, no_right = c == 0 || d == 0;
  if (no_left && no_right) return Guess::zero;
  if (no_right) return (a > 0) == (b > 0) ? Guess::positive : Guess::negative;
  if (no_left) return (c > 0) == (d > 0) ? Guess::positive : Guess::negative;
  return Guess::unsure;
}

// The sign of (a1 - a0) (b1 - b0) + (c1 - c0) (d1 - d0) where doubles hold the differences exactly, as they do for
// numbers of like size, so that their products are exact pairs of doubles (number/double_double.h); else unsure.
Guess sign_of_exact_differences(double a1, double a0, double b1, double b0, double c1, double c0, double d1, double d0);

inline Sign cross_2d(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally) {
  const Guess guess = sign_of_products(q.x - p.x, s.y - r.y, p.y - q.y, s.x - r.x);
  if (!is_sure(guess)) return cross_2d_further(p, q, r, s, tally);
  return counted(&StageTally::rounded, tally, to_sign(guess));
}

inline Sign dot_2d(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally) {
  const Guess guess = sign_of_products(q.x - p.x, s.x - r.x, q.y - p.y, s.y - r.y);
  if (!is_sure(guess)) return dot_2d_further(p, q, r, s, tally);
  return counted(&StageTally::rounded, tally, to_sign(guess));
}

// The same for differences of rounded images, each off by at most e = twice the images' error before its own rounding:
// the exact products differ from those of the computed differences by e (|a| + |b| + |c| + |d|) + 2 e^2 at most, beyond
// the roundings of sign_of_products. The factor 1 + 2^-49 pays for the roundings of this sum itself.
inline Guess sign_of_image_products(double a, double b, double c, double d, double image_error) {
  const double left = a * b, right = c * d, value = left + right, e = 2 * image_error;
  const double sizes = (std::fabs(a) + std::fabs(b)) + (std::fabs(c) + std::fabs(d));
  const double error =
      Rounded<4>::bound * (std::fabs(left) + std::fabs(right)) + (1 + 0x1p-49) * (e * (sizes + 2 * e)) + 0x1p-1060;
  return value > error ? Guess::positive : value < -error ? Guess::negative : Guess::unsure;
}

inline double greatest_error(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s) {
  return std::max(std::max(p.error, q.error), std::max(r.error, s.error));
}

inline Sign cross_2d(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally) {
  const Point2 a = p.rounded_image(), b = q.rounded_image(), c = r.rounded_image(), d = s.rounded_image();
  const Guess guess = sign_of_image_products(b.x - a.x, d.y - c.y, a.y - b.y, d.x - c.x, greatest_error(p, q, r, s));
  if (!is_sure(guess)) return cross_2d_further(p, q, r, s, tally);
  return counted(&StageTally::rounded, tally, to_sign(guess));
}

inline Sign dot_2d(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally) {
  const Point2 a = p.rounded_image(), b = q.rounded_image(), c = r.rounded_image(), d = s.rounded_image();
  const Guess guess = sign_of_image_products(b.x - a.x, d.x - c.x, b.y - a.y, d.y - c.y, greatest_error(p, q, r, s));
  if (!is_sure(guess)) return dot_2d_further(p, q, r, s, tally);
  return counted(&StageTally::rounded, tally, to_sign(guess));
}

}  // namespace sunder
