// Are some points in one plane, exactly? If not, by how much?
// Also called: coplanarity, planarity test.
#pragma once

#include <sunder/predicate/point.h>

#include <array>
#include <cstdint>
#include <span>

namespace sunder::solid {

struct Flatness {
  bool is_flat = true;
  // Where it is not: the vertex `off` is about so far from the plane of three others, and none is further from it.
  std::uint32_t off = 0;
  std::array<std::uint32_t, 3> plane{};
  double distance = 0;  // of exact numbers, rounded; never 0, unless it is below the doubles
};

// The three that the plane goes through are far from each other; which they are, floating point chooses. Requires
// finite points. Cost: linear, with exact signs where the filters leave them.
Flatness flatness(std::span<const Point3> points);

}  // namespace sunder::solid
