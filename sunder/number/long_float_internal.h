// Floating point with mantissas of as many bits as the caller wants, and exponents without end: for searches among
// numbers whose sizes differ by more than a double's exponents do. What is found so is a proposal, no decision.
// Also called: big floats; multiple-precision floating point.
#pragma once

#include <sunder/number/dyadic.h>

#include <cstdint>

namespace sunder {

// Results are rounded to `bits` bits.
struct LongFloats {
  std::int64_t bits = 53;

  Dyadic rounded(Dyadic x) const;
  // Zero where the first half of the bits of the greater one cancel: what is left is likely rounding.
  Dyadic sum(const Dyadic& a, const Dyadic& b) const;
  Dyadic difference(const Dyadic& a, const Dyadic& b) const { return sum(a, -b); }
  Dyadic product(const Dyadic& a, const Dyadic& b) const { return rounded(a * b); }
  Dyadic quotient(const Dyadic& a, const Dyadic& b) const;  // requires b != 0
};

}  // namespace sunder
