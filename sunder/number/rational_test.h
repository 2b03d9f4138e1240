// Doubles and dyadic numbers as fractions.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/integer_internal.h>
#include <tests/support/fraction.h>

#include <cstdint>

namespace sunder {

using Rational = tests::Fraction;

// n 2^e
inline Rational rational(const tests::Integer& n, std::int64_t e) { return Rational(n).scaled(e); }
inline Rational rational(double x) { return Rational(x); }
inline Rational rational(const Dyadic& x) { return rational(tests::Integer(mantissa_of(x).str()), x.exponent()); }

}  // namespace sunder
