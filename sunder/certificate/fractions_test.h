// Doubles, and images of points, in fractions.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/integer_internal.h>
#include <sunder/predicate/point.h>
#include <tests/support/fraction.h>

#include <array>
#include <cstdint>

namespace sunder {

using Whole = tests::Integer;
using Fraction = tests::Fraction;
using Exact3 = std::array<Fraction, 3>;

inline Fraction times_power(const Whole& m, std::int64_t e) { return Fraction(m).scaled(e); }
inline Fraction exact(double x) { return Fraction(x); }
inline Fraction exact(const Dyadic& x) { return times_power(Whole(mantissa_of(x).str()), x.exponent()); }

inline Exact3 image(const Affine3& pose, const Point3& p) {
  Exact3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = exact(pose.linear[3 * i]) * exact(p.x) + exact(pose.linear[3 * i + 1]) * exact(p.y) +
             exact(pose.linear[3 * i + 2]) * exact(p.z) + exact(pose.translation[i]);
  }
  return out;
}

}  // namespace sunder
