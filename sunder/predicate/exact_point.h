// Fractions, and points of space with one denominator, in exact numbers.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/predicate/point.h>

namespace sunder {

// numerator / denominator, not in lowest terms; the denominator is positive.
struct ExactFraction {
  Dyadic numerator, denominator{1.0};
  double nearest() const { return nearest_ratio(numerator, denominator); }  // ties to even
};

// Coordinates x / denominator, y / denominator and z / denominator; the denominator is positive.
struct ExactPoint3 {
  Dyadic x, y, z, denominator{1.0};
};

// The nearest doubles; infinite beyond the range.
Point3 nearest(const ExactPoint3& p);

}  // namespace sunder
