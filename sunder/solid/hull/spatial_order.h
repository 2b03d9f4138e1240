// Points put in an order that is kind to the memory caches. Internal to solid/hull.
#pragma once

#include <sunder/predicate/point.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

// A permutation of the indices such that points next to each other in it tend to be close in space. Equal points stay
// in the order of their indices. Cost: linear.
// Source: Morton 1966: the cells of a grid along a space-filling curve.
std::vector<std::uint32_t> spatial_order(std::span<const Point3> points);

}  // namespace sunder::solid
