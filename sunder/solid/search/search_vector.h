// Vectors as searches use them, in one of two precisions: Real is double or DoubleDouble. Nothing here decides
// anything.
#pragma once

#include <sunder/number/double_double.h>
#include <sunder/number/sign.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/point.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace sunder::solid {

template <class Real>
using VectorOf = std::conditional_t<std::is_same_v<Real, double>, Point3, Vector3<Real>>;

template <class V>
V minus(const V& a, const V& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class V>
V negated(const V& a) {
  return {-a.x, -a.y, -a.z};
}

// Of Vector3: dot and cross of number/vector.h.
inline double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A power of two that brings a size near 1 where sixth powers of it could overflow or vanish, as they occur in
// closest_simplex.cpp; else 1.
inline double scale_to_one(double size) {
  if (size >= 0x1p-100 && size <= 0x1p100) return 1;
  if (!(size > 0 && size <= std::numeric_limits<double>::max())) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(size), -1022, 1022));
}

// In doubles.
template <class V>
Point3 rounded(const V& a) {
  return {nearest(a.x), nearest(a.y), nearest(a.z)};
}

// A product of doubles, rounded to a Real. (Of DoubleDouble: exact.)
template <class Real>
Real product(double a, double b) {
  if constexpr (std::is_same_v<Real, double>) {
    return a * b;
  } else {
    return exact_product(a, b);
  }
}

// A difference of doubles, rounded to a Real. (Of DoubleDouble: exact.)
template <class Real>
Real difference(double a, double b) {
  if constexpr (std::is_same_v<Real, double>) {
    return a - b;
  } else {
    return exact_sum(a, -b);
  }
}

// Times a double, which beside DoubleDouble is a power of two: exactly then, but for underflow and overflow.
inline double scaled(double x, double by) { return x * by; }
inline DoubleDouble scaled(const DoubleDouble& x, double power) { return {x.high * power, x.low * power}; }

// For searches: of what rounding has left.
template <class Real>
Sign sign_of_rounded(const Real& x) {
  return x > Real(0) ? Sign::positive : Real(0) > x ? Sign::negative : Sign::zero;
}

}  // namespace sunder::solid
