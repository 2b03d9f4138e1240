// Numbers n 2^e, exactly: an oracle that shares no code with what it checks.
#pragma once

#include <sunder/number/integer_internal.h>

#include <tests/support/doubles.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace sunder::tests {

using Whole = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

struct Exact {
  Whole n;
  int e = 0;

  Exact(double x) {
    const double m = std::frexp(x, &e);
    n = static_cast<std::int64_t>(std::ldexp(m, 53));
    e -= 53;
  }
  Exact(Whole mantissa, int exponent) : n(std::move(mantissa)), e(exponent) {}
  explicit Exact(const Dyadic& x) : n(mantissa_of(x).str()), e(static_cast<int>(x.exponent())) {}

  Whole at(int exponent) const { return n << static_cast<unsigned>(e - exponent); }
  int sign() const { return n.sign(); }
};
inline Exact operator+(const Exact& a, const Exact& b) {
  const int e = std::min(a.e, b.e);
  return {a.at(e) + b.at(e), e};
}
inline Exact operator-(const Exact& a) { return {-a.n, a.e}; }
inline Exact operator-(const Exact& a, const Exact& b) { return a + (-b); }
inline Exact operator*(const Exact& a, const Exact& b) { return {a.n * b.n, a.e + b.e}; }
inline bool operator==(const Exact& a, const Exact& b) { return (a - b).sign() == 0; }
inline bool operator<=(const Exact& a, const Exact& b) { return (a - b).sign() <= 0; }

}  // namespace sunder::tests
