// Doubles as whole multiples of one small number.
#pragma once

#include <tests/support/exact.h>

#include <cmath>
#include <cstdint>

namespace sunder {

// A number as a multiple of 2^-1126.
constexpr unsigned multiple_bits = 1126;
inline tests::Whole multiple(double x) {
  int e = 0;
  const double m = std::frexp(x, &e);
  const tests::Whole n = static_cast<std::int64_t>(std::ldexp(m, 53));
  const int shift = e - 53 + static_cast<int>(multiple_bits);  // at least -1073 - 53 + 1126
  return n << static_cast<unsigned>(shift);
}

}  // namespace sunder
