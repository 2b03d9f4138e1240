// A closed disc as plain numbers.
#pragma once

#include <sunder/predicate/point.h>

namespace sunder {

// The points at most `radius` from `center`; the radius is not negative. Radius zero is a point.
struct Disc {
  Point2 center;
  double radius = 0;
  friend bool operator==(const Disc&, const Disc&) = default;
};

}  // namespace sunder
