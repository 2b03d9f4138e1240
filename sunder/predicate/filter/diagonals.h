// How far sets of points reach along the diagonals of the plane, rounded: a filter that is sure where it says "apart".
// Also called: discrete oriented polytope (k-DOP); separating axes of fixed directions.
#pragma once

#include <sunder/predicate/point.h>

#include <algorithm>
#include <limits>

namespace sunder {

// The extents of x + y and of x - y over some points, each rounded to the nearest double.
struct DiagonalExtents {
  double low_sum = std::numeric_limits<double>::infinity(), high_sum = -low_sum;
  double low_difference = low_sum, high_difference = -low_sum;

  void include(const Point2& p) {
    const double sum = p.x + p.y, difference = p.x - p.y;
    low_sum = std::min(low_sum, sum);
    high_sum = std::max(high_sum, sum);
    low_difference = std::min(low_difference, difference);
    high_difference = std::max(high_difference, difference);
  }
};

// Is all of one set, and so its convex hull, strictly beyond all of the other along a diagonal? True is sure, for every
// finite double, as rounding keeps order: where two rounded numbers are different, the exact ones are in that order.
// (A sum that overflows is infinite, and no infinity is beyond itself.) False means: not sure.
inline bool surely_apart(const DiagonalExtents& a, const DiagonalExtents& b) {
  return a.high_sum < b.low_sum || b.high_sum < a.low_sum || a.high_difference < b.low_difference ||
         b.high_difference < a.low_difference;
}

}  // namespace sunder
