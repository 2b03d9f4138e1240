// Exact numbers as integers in one unit. For sources, not installed.
#pragma once

#include <sunder/number/integer_internal.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace sunder {

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
  ScaledIntegers result{std::vector<Integer>(numbers.size()), unit == none ? 0 : unit};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k].sign() == Sign::zero) continue;
    result.integers[k] = mantissa_of(numbers[k]) << static_cast<unsigned>(numbers[k].exponent() - unit);
  }
  return result;
}

}  // namespace sunder
