// Multiples of two arrows: which one reaches further to the left of a third arrow? Exact, for every finite double.
//
// Heights of vertices are so compared with a chord over their numbers: with h(k) the height of vertex k, v_k, to the
// left of the arrow pq, the sign of h(k) - (h(0) + k / n (h(n) - h(0))) is chord_order(p, q, n, v_0, v_k, k, v_0, v_n).
#pragma once

#include <sunder/number/rounded.h>
#include <sunder/number/sign.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <cmath>
#include <cstdint>

namespace sunder {

// positive: m times the arrow rs reaches further to the left of the arrow pq than n times the arrow tu; zero: both
// reach equally far, or p and q are one point; negative: less far. Exchanging the two multiples flips the sign, and so
// does turning pq round. Formula: (q - p) x (m (s - r) - n (u - t)). Stages: floating point, intervals, exact numbers.
// Points are plain (Point2) or under poses (Posed2, whose exact images are meant); all of one kind.
inline Sign chord_order(const Point2& p, const Point2& q, std::uint32_t m, const Point2& r, const Point2& s,
                        std::uint32_t n, const Point2& t, const Point2& u, StageTally* tally = nullptr);
Sign chord_order(const Posed2& p, const Posed2& q, std::uint32_t m, const Posed2& r, const Posed2& s, std::uint32_t n,
                 const Posed2& t, const Posed2& u, StageTally* tally = nullptr);

// chord_order for what its first stage does not decide.
Sign chord_order_further(const Point2& p, const Point2& q, std::uint32_t m, const Point2& r, const Point2& s,
                         std::uint32_t n, const Point2& t, const Point2& u, StageTally* tally);

// The first stage: the formula as a Rounded<6>, whose magnitude is the sum of the four products' sizes. Differences of
// doubles never underflow, nor do whole multiples of them and the differences of those. Each outer product that
// underflows is off by at most 2^-1075, which the last summand pays for many times over. Overflow makes the error
// infinite or the comparisons false.
inline Sign chord_order(const Point2& p, const Point2& q, std::uint32_t m, const Point2& r, const Point2& s,
                        std::uint32_t n, const Point2& t, const Point2& u, StageTally* tally) {
  const double x = q.x - p.x, y = q.y - p.y;
  const double left_x = m * (s.x - r.x), left_y = m * (s.y - r.y);
  const double right_x = n * (u.x - t.x), right_y = n * (u.y - t.y);
  const double value = x * (left_y - right_y) - y * (left_x - right_x);
  const double error = Rounded<6>::bound * (std::fabs(x) * (std::fabs(left_y) + std::fabs(right_y)) +
                                            std::fabs(y) * (std::fabs(left_x) + std::fabs(right_x))) +
                       0x1p-1060;
  if (value > error || value < -error)
    return counted(&StageTally::rounded, tally, value > 0 ? Sign::positive : Sign::negative);
  return chord_order_further(p, q, m, r, s, n, t, u, tally);
}

}  // namespace sunder
