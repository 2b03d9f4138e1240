// Numbers as people give them, near those of a search: bodies that touch mostly do so there. For the sources of
// solid/round.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/predicate/disc/round_shape.h>

#include <array>
#include <cmath>
#include <utility>

namespace sunder::solid {

// To multiples of 2^-bits.
inline Point3 snapped(const Point3& p, int bits) {
  const auto part = [bits](double x) { return std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits); };
  return {part(p.x), part(p.y), part(p.z)};
}

// Near the coordinates, with denominators of at most 2^20: by continued fractions. What is above 2^20 is rounded down.
inline ExactPoint3 simple_fractions(const Point3& p) {
  constexpr double most = 0x1p20;
  std::array<double, 3> n{}, d{1, 1, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    double rest = p[k], last_n = 1, last_d = 0;
    n[k] = std::floor(rest);
    for (int i = 0; i < 30; ++i) {
      const double part = rest - std::floor(rest);
      if (!(part > 0x1p-24) || std::fabs(n[k]) > most) break;
      rest = 1 / part;
      const double next_n = std::floor(rest) * n[k] + last_n, next_d = std::floor(rest) * d[k] + last_d;
      if (!(next_d <= most)) break;
      last_n = std::exchange(n[k], next_n);
      last_d = std::exchange(d[k], next_d);
    }
  }
  const Dyadic x(d[0]), y(d[1]), z(d[2]);
  return {Dyadic(n[0]) * y * z, x * Dyadic(n[1]) * z, x * y * Dyadic(n[2]), x * y * z};
}

}  // namespace sunder::solid
