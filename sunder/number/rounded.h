// Floating point with a derived error bound: the first stage of a predicate.
// Also called: floating-point filter; semi-static filter; running error analysis.
//
// A Rounded<K> is what floating point made of an expression, together with what is needed to bound the error. K counts
// roundings and is known at compile time; only the magnitude is computed at run time.
//
// Let u = 2^-53. For an expression over exact doubles by +, -, * write X for the same expression with every leaf
// replaced by its absolute value and every - by +. Without overflow or underflow
//   R1. |value - exact| <= ((1 + u)^K - 1) X
//   R2. X <= magnitude / (1 - u)^K
// Leaves have K = 0, a sum max(Ka, Kb) + 1, a product Ka + Kb + 1 roundings: expand the expression into monomials;
// each carries at most K factors (1 + d), |d| <= u (Higham 2002, section 3.1). For sums and products of two leaves
// the value itself serves as the magnitude, because then |value - exact| <= u |exact|.
//   R3. |value - exact| <= bound<K> * magnitude, computed in floating point.
// From R1 and R2 the factor needed is at most K u (1 + 3 K u) for K u < 0.1; one more unit pays for this and for the
// rounding of the product: bound<K> = (K + 1) u.
//
// Overflow makes the magnitude infinite, and the sign unsure. Underflow is not seen: use `tame` or an argument of that
// kind before trusting a sign (see there).
#pragma once

#include <sunder/number/sign.h>

#include <algorithm>
#include <cmath>

#ifdef __FAST_MATH__
#error "Sunder needs IEEE arithmetic: compile without -ffast-math."
#endif

namespace sunder {

template <int K>
struct Rounded {
  double value;
  double magnitude;

  static constexpr double bound = (K + 1) * 0x1p-53;
  static_assert(K < 1 << 20, "the derivation of the bound needs K u far below 1");
};

inline Rounded<0> leaf(double x) { return {x, std::fabs(x)}; }

template <int J, int K>
constexpr int sum_roundings = (J > K ? J : K) + 1;

template <int J, int K>
inline Rounded<sum_roundings<J, K>> operator+(Rounded<J> a, Rounded<K> b) {
  const double sum = a.value + b.value;
  if constexpr (J == 0 && K == 0) {
    return {sum, std::fabs(sum)};
  } else {
    return {sum, a.magnitude + b.magnitude};
  }
}

template <int J, int K>
inline Rounded<sum_roundings<J, K>> operator-(Rounded<J> a, Rounded<K> b) {
  return a + Rounded<K>{-b.value, b.magnitude};
}

template <int J, int K>
inline Rounded<J + K + 1> operator*(Rounded<J> a, Rounded<K> b) {
  return {a.value * b.value, a.magnitude * b.magnitude};
}

template <int K>
inline Guess sign(Rounded<K> x) {
  const double error = Rounded<K>::bound * x.magnitude;
  if (x.value > error) return Guess::positive;
  if (x.value < -error) return Guess::negative;
  if (x.magnitude == 0) return Guess::zero;  // every monomial is exactly zero, given no underflow
  return Guess::unsure;
}

// True when products of up to three such numbers, or of sums and differences of two of them, neither overflow nor
// underflow: each nonzero number is a multiple of 2^-332 in [2^-280, 2^280], so a product of three is a multiple of
// 2^-996, and so are sums of such products; all stay below 2^850.
inline bool tame(double x) {
  const double size = std::fabs(x);
  return (size >= 0x1p-280 && size <= 0x1p280) || size == 0;
}

}  // namespace sunder
