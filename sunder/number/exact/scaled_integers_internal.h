// Exact numbers as integers in one unit. For sources, not installed.
#pragma once

#include <sunder/number/integer_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace sunder {

// Every double of at least this size, which is not 0, is a multiple of 2 to this.
inline std::int64_t least_exponent(double size) { return std::max<std::int64_t>(std::ilogb(size) - 52, -1074); }

// x / 2^unit. Requires that this is whole.
inline Integer in_unit(const Dyadic& x, std::int64_t unit) {
  if (x.sign() == Sign::zero) return 0;
  return mantissa_of(x) << static_cast<unsigned>(x.exponent() - unit);
}

// Number k is integers[k] 2^unit, and the unit the greatest power of two for which that is so, or nearly; 0 where all
// are zero.
struct ScaledIntegers {
  std::vector<Integer> integers;
  std::int64_t unit = 0;
};

inline ScaledIntegers scaled_integers(std::span<const Dyadic> numbers) {
  constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  std::int64_t unit = none;
  for (const Dyadic& x : numbers) {
    if (x.sign() != Sign::zero) unit = std::min(unit, x.exponent());
  }
  ScaledIntegers result{{}, unit == none ? 0 : unit};
  result.integers.reserve(numbers.size());
  for (const Dyadic& x : numbers) result.integers.push_back(in_unit(x, result.unit));
  return result;
}

}  // namespace sunder
