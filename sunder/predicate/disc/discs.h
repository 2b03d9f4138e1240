// How far apart are two centres, compared with the radii; and which of two sums is larger? Exact, for every finite
// double.
#pragma once

#include <sunder/number/rounded.h>
#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

namespace sunder {

// Of closed discs of radius r around p and s around q, r, s >= 0: positive: they are apart; zero: they touch from
// outside (where r or s is zero: one is a point on the circle of the other); negative: some point of one is inside of
// the other. Symmetric. Formula: |q - p|^2 - (r + s)^2. Stages: floating point, exact differences, intervals, exact
// numbers.
inline Sign distance_against_sum(const Point2& p, double r, const Point2& q, double s, StageTally* tally = nullptr);

// positive: neither disc holds the other; zero: one holds the other and their circles touch (or are equal); negative:
// one holds the other, and their circles have no common point. Symmetric. Formula: |q - p|^2 - (r - s)^2.
inline Sign distance_against_difference(const Point2& p, double r, const Point2& q, double s,
                                        StageTally* tally = nullptr);

// The sign of (a + b) - (c + d). Rounding keeps order: where the rounded sums differ, they decide, without a bound;
// else what was rounded off, which doubles hold.
inline Sign compare_sums(double a, double b, double c, double d, StageTally* tally = nullptr);

// What the first stages do not decide. Of the formula with r + s; s may be negative here.
Sign distance_against_further(const Point2& p, double r, const Point2& q, double s, StageTally* tally);
Sign compare_sums_further(double a, double b, double c, double d, StageTally* tally);

// The first stage of |q - p|^2 - reach^2, where reach is a sum of two doubles, rounded: the formula as a Rounded<5>,
// whose magnitude is the sum of the three squares. Sums of doubles never underflow; a square that does is off by at
// most 2^-1075, which the last term pays for many times over. Overflow makes the error infinite or the comparisons
// false.
inline Guess rounded_distance_against(const Point2& p, const Point2& q, double reach) {
  const double x = q.x - p.x, y = q.y - p.y;
  const double distance = x * x + y * y, square = reach * reach, value = distance - square;
  const double error = Rounded<5>::bound * (distance + square) + 0x1p-1060;
  return value > error ? Guess::positive : value < -error ? Guess::negative : Guess::unsure;
}

inline Sign distance_against_sum(const Point2& p, double r, const Point2& q, double s, StageTally* tally) {
  const Guess guess = rounded_distance_against(p, q, r + s);
  if (!is_sure(guess)) return distance_against_further(p, r, q, s, tally);
  return counted(&StageTally::rounded, tally, to_sign(guess));
}

inline Sign distance_against_difference(const Point2& p, double r, const Point2& q, double s, StageTally* tally) {
  const Guess guess = rounded_distance_against(p, q, r - s);
  if (!is_sure(guess)) return distance_against_further(p, r, q, -s, tally);
  return counted(&StageTally::rounded, tally, to_sign(guess));
}

inline Sign compare_sums(double a, double b, double c, double d, StageTally* tally) {
  const double left = a + b, right = c + d;
  if (left == right) return compare_sums_further(a, b, c, d, tally);
  return counted(&StageTally::rounded, tally, left > right ? Sign::positive : Sign::negative);
}

}  // namespace sunder
