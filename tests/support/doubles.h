// The ends of the doubles, and neighbours.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace sunder::tests {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

inline double moved_by_bits(double x, std::int64_t bits) {
  for (; bits > 0; --bits) x = std::nextafter(x, infinity);
  for (; bits < 0; ++bits) x = std::nextafter(x, -infinity);
  return x;
}

}  // namespace sunder::tests
