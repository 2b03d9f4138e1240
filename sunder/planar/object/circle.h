// Circles of the plane, with their insides: closed discs. So nested ones have common points. Radius zero is a point.
#pragma once

#include <sunder/predicate/point.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

struct Circle {
  Point2 center;
  double radius = 0;  // not negative
  friend bool operator==(const Circle&, const Circle&) = default;
};

// A set of circles, numbered from 0. Immutable; any number of threads may use it.
// P1. All numbers are finite, and no radius is negative. (Centre plus radius may lie beyond the doubles.)
class Circles {
 public:
  // Throws Error bad_value: "circle 7: ..." where a number is not finite or a radius is negative; bad_shape for 2^31
  // circles or more.
  explicit Circles(std::span<const Circle> given);

  std::uint32_t size() const { return static_cast<std::uint32_t>(circles_.size()); }
  const Circle& operator[](std::uint32_t i) const { return circles_[i]; }
  std::span<const Circle> all() const { return circles_; }

 private:
  std::vector<Circle> circles_;
};

}  // namespace sunder::planar
