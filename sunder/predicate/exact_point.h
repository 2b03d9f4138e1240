// Points with one denominator, in exact numbers: of the plane (D = 2), of space (D = 3), and of R^d.
// Also called: homogeneous coordinates.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cstddef>
#include <vector>

namespace sunder {

// Each coordinate is over the denominator, which is positive where nothing else is said.
template <std::size_t D>
struct ExactPoint;

template <>
struct ExactPoint<2> {
  Dyadic x, y, denominator{1.0};
  const Dyadic& operator[](std::size_t k) const { return k == 0 ? x : y; }
  Vector2<Dyadic> numerators() const { return {x, y}; }
};

template <>
struct ExactPoint<3> {
  Dyadic x, y, z, denominator{1.0};
  const Dyadic& operator[](std::size_t k) const { return k == 0 ? x : k == 1 ? y : z; }
  Vector3<Dyadic> numerators() const { return {x, y, z}; }
};

// Of any dimension.
inline constexpr std::size_t any_dimension = 0;
template <>
struct ExactPoint<any_dimension> {
  std::vector<Dyadic> numbers{};
  Dyadic denominator{1.0};
};

using ExactPoint2 = ExactPoint<2>;
using ExactPoint3 = ExactPoint<3>;
using ExactPointN = ExactPoint<any_dimension>;

inline ExactPoint2 exactly(const Point2& p) { return {p.x, p.y, 1.0}; }
inline ExactPoint3 exactly(const Point3& p) { return {p.x, p.y, p.z, 1.0}; }
inline ExactPoint3 exact_point(const Vector3<Dyadic>& numerators, const Dyadic& denominator = Dyadic(1.0)) {
  return {numerators.x, numerators.y, numerators.z, denominator};
}

// In the plane z = 0.
inline ExactPoint3 in_space(const ExactPoint2& p) { return {p.x, p.y, Dyadic(), p.denominator}; }

// The nearest doubles; infinite beyond the range.
Point2 nearest(const ExactPoint2& p);
Point3 nearest(const ExactPoint3& p);

}  // namespace sunder
