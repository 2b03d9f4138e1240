// What searches in doubles share: coordinates of a size that they can square, and the products of two vectors.
#pragma once

#include <sunder/predicate/point.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace sunder::planar {

// A power of two that brings these coordinates near 1, so that products neither overflow nor underflow; 1 where that
// would not help (all are zero, or one is no number). Scaling the objects by a power of two does not change a search.
inline double scale_near_one(std::initializer_list<Point2> points) {
  double greatest = 0;
  for (const Point2& p : points) greatest = std::max({greatest, std::fabs(p.x), std::fabs(p.y)});
  if (!(greatest > 0) || std::isinf(greatest)) return 1;
  constexpr std::uint64_t bias = 1023, least = bias - 1000, most = bias + 1000;  // 2^e is stored as e + bias
  const std::uint64_t stored = std::clamp(std::bit_cast<std::uint64_t>(greatest) >> 52, least, most);
  return std::bit_cast<double>((2 * bias - stored) << 52);
}

namespace in_doubles {
inline Point2 scaled(const Point2& p, double scale) { return {p.x * scale, p.y * scale}; }
inline Point2 operator-(const Point2& p, const Point2& q) { return {p.x - q.x, p.y - q.y}; }
inline double cross(const Point2& u, const Point2& v) { return u.x * v.y - u.y * v.x; }
inline double dot(const Point2& u, const Point2& v) { return u.x * v.x + u.y * v.y; }
}  // namespace in_doubles

}  // namespace sunder::planar
