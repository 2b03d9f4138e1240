// Vectors of exact numbers: sums, multiples, and whether one is zero.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/sign.h>
#include <sunder/number/vector.h>

namespace sunder {

inline Vector3<Dyadic> sum(const Vector3<Dyadic>& u, const Vector3<Dyadic>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}

inline Vector3<Dyadic> times(const Dyadic& factor, const Vector3<Dyadic>& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

inline bool is_zero(const Vector3<Dyadic>& v) {
  return v.x.sign() == Sign::zero && v.y.sign() == Sign::zero && v.z.sign() == Sign::zero;
}

}  // namespace sunder
