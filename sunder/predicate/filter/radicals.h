// Signs of numbers with square roots, by repeated squaring: for the number types of the stages (see stages.h). Roots
// are never taken, so exact numbers give an exact sign; the other types a sign, or unsure.
// Also called: signs of sums of square roots; root-free comparison.
#pragma once

#include <sunder/number/sign.h>

namespace sunder {

// The sign of a + b s, where s > 0 (s >= 0 where s_is_positive is false) and the signs of a and b are given; the sign
// of a^2 - b^2 s^2 is called for only where it is needed.
template <class OfSquares>
Guess sign_of_sum(Guess a, Guess b, bool s_is_positive, const OfSquares& of_squares) {
  if (!is_sure(a) || !is_sure(b)) return Guess::unsure;
  if (a == b || b == Guess::zero) return a;
  if (a == Guess::zero) return s_is_positive ? b : Guess::unsure;
  const Guess larger = of_squares();
  if (!is_sure(larger) || larger == Guess::zero) return larger;
  return larger == Guess::positive ? a : b;
}

// The sign of a + b sqrt(p). Requires that p, exactly, is at least zero.
template <class A, class B, class P>
Guess sign_with_root(const A& a, const B& b, const P& p) {
  const Guess of_p = sign(p);
  if (of_p == Guess::zero) return sign(a);
  return sign_of_sum(sign(a), sign(b), of_p == Guess::positive, [&] { return sign(a * a - (b * b) * p); });
}

// The sign of a + b sqrt(p) + c sqrt(q) + d sqrt(p q). Requires that p and q, exactly, are at least zero.
template <class T>
Guess sign_with_roots(const T& a, const T& b, const T& c, const T& d, const T& p, const T& q) {
  const Guess of_q = sign(q);
  if (of_q == Guess::zero) return sign_with_root(a, b, p);
  return sign_of_sum(sign_with_root(a, b, p), sign_with_root(c, d, p), of_q == Guess::positive, [&] {
    const T ab = a * b, cd = c * d;
    return sign_with_root((a * a + (b * b) * p) - q * (c * c + (d * d) * p), (ab + ab) - q * (cd + cd), p);
  });
}

}  // namespace sunder
