// Images of points in exact numbers that share no code with the predicates.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <tests/support/exact.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace sunder {

using ExactVector = std::array<tests::Exact, 3>;

inline Sign sign_of(const tests::Exact& x) { return static_cast<Sign>(x.sign()); }

inline ExactVector image(const Point3& p) { return {p.x, p.y, p.z}; }
inline ExactVector image(const Posed3& p) {
  const auto& [m, t] = *p.pose;
  const ExactVector x = image(p.point);
  return {x[0] * m[0] + x[1] * m[1] + x[2] * m[2] + t[0], x[0] * m[3] + x[1] * m[4] + x[2] * m[5] + t[1],
          x[0] * m[6] + x[1] * m[7] + x[2] * m[8] + t[2]};
}

inline double power_of_two(std::int64_t e) { return std::ldexp(1.0, static_cast<int>(e)); }

}  // namespace sunder
