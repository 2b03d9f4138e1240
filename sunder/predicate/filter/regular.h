// Is a linear map surely invertible, by one look in doubles? Where it does not tell, determinant_sign (orient.h) does.
#pragma once

#include <sunder/predicate/point.h>

namespace sunder {

// Surely, of the linear part of a pose whose greatest entry has the size `greatest`. False also means: not sure; so for
// entries that are not finite, and where something might underflow. The determinant, six products of three entries, is
// within 6 greatest^3 times seven roundings of the exact one.
inline bool is_surely_regular(const Affine3& pose, double greatest) {
  if (!(greatest >= 0x1p-300 && greatest <= 0x1p300)) return false;
  const auto& m = pose.linear;
  const double determinant =
      m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
  const double error = 0x1p-40 * (greatest * greatest * greatest);
  return determinant > error || -determinant > error;
}

}  // namespace sunder
