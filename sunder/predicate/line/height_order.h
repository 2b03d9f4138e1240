// Which of two lines is higher at an abscissa? Exact, for every finite double.
// Also called: vertical order of lines; order along a vertical sweep line.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/number/rounded.h>
#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <cmath>

namespace sunder {

// positive: at this x the line ab is above the line cd; zero: they meet there; negative: it is below.
// Requires a.x < b.x and c.x < d.x. Exchanging the lines flips the sign.
// Formula, with u = b - a and v = d - c: (a.y - c.y) u.x v.x + u.y (x - a.x) v.x - v.y (x - c.x) u.x, which is the
// difference of the heights times u.x v.x. Stages: floating point, intervals, double-doubles, exact numbers.
inline Sign height_order(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double x,
                         StageTally* tally = nullptr);

// height_order for what its first stage does not decide.
Sign height_order_further(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double x,
                          StageTally* tally);

// The first stage: the formula as a Rounded<7>, whose magnitude is the sum of the three products' sizes. Differences of
// doubles never underflow. The inner product of each term is off by at most 2^-1075 where it underflows, which its
// outer factor multiplies; the outer one is off by as much again. The last summand pays for this many times over. (It
// is no subnormal number, as multiplying these takes a hundred cycles.) Overflow makes the error infinite or the
// comparisons false.
inline Sign height_order(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double x,
                         StageTally* tally) {
  SUNDER_REQUIRE(a.x < b.x && c.x < d.x);
  const double run = b.x - a.x, other_run = d.x - c.x, rise = a.y - c.y;
  const double apart = rise * (run * other_run);
  const double left = other_run * ((b.y - a.y) * (x - a.x)), right = run * ((d.y - c.y) * (x - c.x));
  const double value = (apart + left) - right;
  const double error = Rounded<7>::bound * ((std::fabs(apart) + std::fabs(left)) + std::fabs(right)) +
                       0x1p-1020 * (1 + std::fabs(rise) + run + other_run);
  if (value > error || value < -error)
    return counted(&StageTally::rounded, tally, value > 0 ? Sign::positive : Sign::negative);
  return height_order_further(a, b, c, d, x, tally);
}

}  // namespace sunder
