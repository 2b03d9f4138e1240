// The coordinates of a point, or of the image of a posed point, as numbers of a type: exact ones (Dyadic), or with a
// bound of what they are off by (Estimate, Interval).
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <cstddef>

namespace sunder {

// How formulas read a double: as a stage (predicate/filter/stages.h) of one type of numbers.
template <class Number>
struct NumberStage {
  static Number read(double x) { return x; }
};

// Points as vectors of a stage's numbers.
template <class Stage>
auto lift(const Point3& p) {
  const auto x = Stage::read(p.x);
  return Vector3<decltype(Stage::read(0.0))>{x, Stage::read(p.y), Stage::read(p.z)};
}

template <class Stage>
auto lift(const Point2& p) {
  const auto x = Stage::read(p.x);
  return Vector2<decltype(Stage::read(0.0))>{x, Stage::read(p.y)};
}

template <class Stage>
auto lift(const Posed2& p) {
  const auto v = lift<Stage>(p.point);
  const auto row = [&](std::size_t i) {
    const auto& m = p.pose->linear;
    return (Stage::read(m[2 * i]) * v.x + Stage::read(m[2 * i + 1]) * v.y) + Stage::read(p.pose->translation[i]);
  };
  return Vector2<decltype(row(0))>{row(0), row(1)};
}

template <class Stage>
auto lift(const Posed3& p) {
  const auto v = lift<Stage>(p.point);
  const auto row = [&](int i) {
    const std::size_t r = static_cast<std::size_t>(3 * i);
    const auto& m = p.pose->linear;
    return (Stage::read(m[r]) * v.x + Stage::read(m[r + 1]) * v.y) +
           (Stage::read(m[r + 2]) * v.z + Stage::read(p.pose->translation[static_cast<std::size_t>(i)]));
  };
  return Vector3<decltype(row(0))>{row(0), row(1), row(2)};
}

// Of a Point2, Point3, Posed2 or Posed3.
template <class Number, class P>
auto coordinates(const P& p) {
  return lift<NumberStage<Number>>(p);
}

// What floating point makes of an image: the value of lift<RoundedStage>(p), without the magnitude.
inline Vector3<double> rounded_image(const Posed3& p) {
  const auto row = [&](std::size_t i) {
    const auto& m = p.pose->linear;
    return (m[3 * i] * p.point.x + m[3 * i + 1] * p.point.y) + (m[3 * i + 2] * p.point.z + p.pose->translation[i]);
  };
  return {row(0), row(1), row(2)};
}

}  // namespace sunder
