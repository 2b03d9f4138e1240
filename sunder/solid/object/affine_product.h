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
  const auto entry = [&](std::size_t i, std::size_t j) {
    return a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
  };
  const auto moved = [&](std::size_t i) { return a[3 * i] * t[0] + a[3 * i + 1] * t[1] + a[3 * i + 2] * t[2] + s[i]; };
  static_assert(sizeof(Affine3) == 6 * sizeof(Lanes));
  return std::bit_cast<Affine3>(std::array<Lanes, 6>{Lanes{entry(0, 0), entry(0, 1)}, Lanes{entry(0, 2), entry(1, 0)},
                                                     Lanes{entry(1, 1), entry(1, 2)}, Lanes{entry(2, 0), entry(2, 1)},
                                                     Lanes{entry(2, 2), moved(0)}, Lanes{moved(1), moved(2)}});
}

}  // namespace sunder::solid
