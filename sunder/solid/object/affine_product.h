// The product of two affine maps, for those who make thousands of poses of it.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/predicate/point.h>

#include <array>
#include <bit>
#include <cstddef>

namespace sunder::solid {

// `inner` first, then `outer`, rounded to doubles. Stored two numbers at a time, as poses read them: a processor that
// has to put together what it reads from two stores waits for both.
inline Affine3 affine_product(const Affine3& outer, const Affine3& inner) {
  const auto &a = outer.linear, &b = inner.linear;
  const auto &s = outer.translation, &t = inner.translation;
  // Of row i of the product, the first two entries, and the third with the number of the translation.
  const auto left = [&](std::size_t i) {
    return a[3 * i] * Lanes{b[0], b[1]} + a[3 * i + 1] * Lanes{b[3], b[4]} + a[3 * i + 2] * Lanes{b[6], b[7]};
  };
  const auto right = [&](std::size_t i) {
    return a[3 * i] * Lanes{b[2], t[0]} + a[3 * i + 1] * Lanes{b[5], t[1]} + a[3 * i + 2] * Lanes{b[8], t[2]};
  };
  const Lanes l0 = left(0), l1 = left(1), l2 = left(2), r0 = right(0), r1 = right(1), r2 = right(2);
  static_assert(sizeof(Affine3) == 6 * sizeof(Lanes));
  return std::bit_cast<Affine3>(std::array<Lanes, 6>{l0, Lanes{r0[0], l1[0]}, Lanes{l1[1], r1[0]}, l2,
                                                     Lanes{r2[0], r0[1] + s[0]}, Lanes{r1[1] + s[1], r2[1] + s[2]}});
}

}  // namespace sunder::solid
