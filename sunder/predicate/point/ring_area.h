// The sign of the area that a ring of points encloses. Exact, for every finite double.
// Also called: orientation of a polygon; shoelace formula.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>

#include <cstdint>
#include <span>

namespace sunder {

// ring: numbers of points, of space, projected along an axis as orient_2d_along() does. positive: the ring goes around
// more area counter-clockwise than clockwise, each part counted as often as it is gone around. Cost: linear, in exact
// numbers.
Sign ring_area_along(int axis, std::span<const Point3> points, std::span<const std::uint32_t> ring);

}  // namespace sunder
