// Half-planes and the corners of their lines: how they lie to each other. Exact, for every finite double.
// Also called: vertices of an arrangement of lines against a line.
//
// A half-plane is given by a constraint, a x + b y <= c, or by an arrow, as what is left of it. Each function is for
// both kinds; all half-planes of a call are of one kind. The normal of a half-plane points out of it; angles are those
// of normals. One formula serves both kinds: an arrow is lifted to the three coefficients of its constraint first.
#pragma once

#include <sunder/number/rounded.h>
#include <sunder/number/sign.h>
#include <sunder/predicate/line/arrows.h>
#include <sunder/predicate/line/crossing.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/predicate/posed.h>

#include <cmath>

namespace sunder {

// The points (x, y) with a x + b y <= c. Every function here requires that a and b are not both zero.
struct Constraint {
  double a = 0, b = 0, c = 0;
  friend bool operator==(const Constraint&, const Constraint&) = default;
};

// The points to the left of the arrow, and those on its line. Requires two different points.
struct LeftOf {
  Point2 from, to;
  friend bool operator==(const LeftOf&, const LeftOf&) = default;
};

// Is the normal's angle, from the x axis, at least a half turn (and less than a whole one)?
inline bool points_down(const Constraint& i) { return i.b < 0 || (i.b == 0 && i.a < 0); }
inline bool points_down(const LeftOf& i) { return i.from.x < i.to.x || (i.from.x == i.to.x && i.to.y < i.from.y); }

// The half-plane of that normal, through the origin; p and q are not both zero.
template <class Half>
Half through_origin(double p, double q);
template <>
inline Constraint through_origin<Constraint>(double p, double q) {
  return {p, q, 0};
}
template <>
inline LeftOf through_origin<LeftOf>(double p, double q) {
  return {{0, 0}, {-q, p}};
}

// positive: the normal of j is counter-clockwise of that of i, by less than a half turn; zero: they are parallel.
inline Sign turn(const Constraint& i, const Constraint& j, StageTally* tally = nullptr);
inline Sign turn(const LeftOf& i, const LeftOf& j, StageTally* tally = nullptr) {
  return cross_2d(i.from, i.to, j.from, j.to, tally);
}

// positive: the normals are less than a right angle apart; negative: more.
inline Sign facing(const Constraint& i, const Constraint& j, StageTally* tally = nullptr);
inline Sign facing(const LeftOf& i, const LeftOf& j, StageTally* tally = nullptr) {
  return dot_2d(i.from, i.to, j.from, j.to, tally);
}

// Requires normals of one direction. positive: i is a proper part of j; zero: they are equal; negative: j is one of i.
inline Sign tighter(const Constraint& i, const Constraint& j, StageTally* tally = nullptr);
inline Sign tighter(const LeftOf& i, const LeftOf& j, StageTally* tally = nullptr) {
  return -orient_2d(i.from, i.to, j.from, tally);
}

// Requires normals of opposite directions. positive: a strip is common to i and j; zero: a line; negative: nothing.
inline Sign gap(const Constraint& i, const Constraint& j, StageTally* tally = nullptr);
inline Sign gap(const LeftOf& i, const LeftOf& j, StageTally* tally = nullptr) {
  return orient_2d(i.from, i.to, j.from, tally);
}

// Requires turn(i, j) to be positive. Of the corner, the common point of the lines of i and j: positive: it lies
// outside of k; zero: on its line; negative: inside.
// Formula: a_k (c_i b_j - c_j b_i) + b_k (a_i c_j - a_j c_i) - c_k (a_i b_j - b_i a_j), the corner by Cramer's rule.
// Where the three normals turn around once it is -(l_i c_i + l_j c_j + l_k c_k) for the positive l with which the sum
// of l (a, b) is zero (multipliers, below): so it is positive iff the three have no common point.
inline Sign corner_side(const Constraint& i, const Constraint& j, const Constraint& k, StageTally* tally = nullptr);
inline Sign corner_side(const LeftOf& i, const LeftOf& j, const LeftOf& k, StageTally* tally = nullptr);

// The corner. Requires that turn(i, j) is not zero. Cost: exact arithmetic.
ExactPoint2 exact_corner(const Constraint& i, const Constraint& j);
ExactPoint2 exact_corner(const LeftOf& i, const LeftOf& j);

// A point of the half-plane's line: the one nearest to the origin; where the arrow begins.
ExactPoint2 exact_point_on(const Constraint& i);
ExactPoint2 exact_point_on(const LeftOf& i);

// The numbers a, b, c of the half-plane as a constraint.
struct ExactConstraint {
  Dyadic a, b, c;
};
ExactConstraint exact_constraint(const Constraint& i);
ExactConstraint exact_constraint(const LeftOf& i);

// What the first stages do not decide.
Sign offsets_further(double c, double d, double e, double f, StageTally* tally);  // of c d + e f
Sign corner_side_further(const Constraint& i, const Constraint& j, const Constraint& k, StageTally* tally);
Sign corner_side_further(const LeftOf& i, const LeftOf& j, const LeftOf& k, StageTally* tally);

namespace constraints_detail {

inline Sign sign_of_two_products(double c, double d, double e, double f, StageTally* tally) {
  const Guess guess = sign_of_products(c, d, e, f);
  if (!is_sure(guess)) return offsets_further(c, d, e, f, tally);
  return counted(&StageTally::rounded, tally, to_sign(guess));
}

}  // namespace constraints_detail

inline Sign turn(const Constraint& i, const Constraint& j, StageTally* tally) {
  return constraints_detail::sign_of_two_products(i.a, j.b, -i.b, j.a, tally);
}

inline Sign facing(const Constraint& i, const Constraint& j, StageTally* tally) {
  return constraints_detail::sign_of_two_products(i.a, j.a, i.b, j.b, tally);
}

// Offsets c are compared where the normals are scaled to one size: any one coordinate that is not zero tells theirs.
inline Sign tighter(const Constraint& i, const Constraint& j, StageTally* tally) {
  const bool by_a = i.a != 0;
  const double size_i = std::fabs(by_a ? i.a : i.b), size_j = std::fabs(by_a ? j.a : j.b);
  return constraints_detail::sign_of_two_products(j.c, size_i, -i.c, size_j, tally);
}

inline Sign gap(const Constraint& i, const Constraint& j, StageTally* tally) {
  const bool by_a = i.a != 0;
  const double size_i = std::fabs(by_a ? i.a : i.b), size_j = std::fabs(by_a ? j.a : j.b);
  return constraints_detail::sign_of_two_products(i.c, size_j, j.c, size_i, tally);
}

// A corner that many half-planes are compared with: what the formula has to do with i and j alone. Of arrows, nothing.
template <class Half>
struct FixedCorner {
  Half i, j;
};
template <>
struct FixedCorner<Constraint> {
  Constraint i, j;
  double x, y, d, size_x, size_y, size_d;
  FixedCorner(const Constraint& first, const Constraint& second) : i(first), j(second) {
    const double cb = i.c * j.b, bc = i.b * j.c, ac = i.a * j.c, ca = i.c * j.a, ab = i.a * j.b, ba = i.b * j.a;
    x = cb - bc;
    y = ac - ca;
    d = ab - ba;
    size_x = std::fabs(cb) + std::fabs(bc);
    size_y = std::fabs(ac) + std::fabs(ca);
    size_d = std::fabs(ab) + std::fabs(ba);
  }
};

// The first stage: the formula as a Rounded<5>. A product that underflows is off by at most 2^-1075; the inner ones are
// then multiplied by a coefficient of k: the last term pays for all of them many times over. (It is no subnormal
// number, as multiplying these takes a hundred cycles.) Overflow makes the error infinite or the comparisons false.
inline Sign corner_side(const FixedCorner<Constraint>& corner, const Constraint& k, StageTally* tally = nullptr) {
  const double value = k.a * corner.x + k.b * corner.y - k.c * corner.d;
  const double a = std::fabs(k.a), b = std::fabs(k.b), c = std::fabs(k.c);
  const double size = a * corner.size_x + b * corner.size_y + c * corner.size_d;
  const double error = Rounded<5>::bound * size + 0x1p-1020 * (a + b + c + 1);
  if (value > error || value < -error)
    return counted(&StageTally::rounded, tally, value > 0 ? Sign::positive : Sign::negative);
  return corner_side_further(corner.i, corner.j, k, tally);
}
inline Sign corner_side(const FixedCorner<LeftOf>& corner, const LeftOf& k, StageTally* tally = nullptr) {
  return corner_side(corner.i, corner.j, k, tally);
}
inline Sign corner_side(const Constraint& i, const Constraint& j, const Constraint& k, StageTally* tally) {
  return corner_side(FixedCorner<Constraint>(i, j), k, tally);
}

// The first stage for arrows: all is seen from where k begins, so that c_k is zero. The coefficients a, b are
// Rounded<1>, the offsets c Rounded<4>, the formula Rounded<10>. Differences never underflow. With A the sum of the
// sizes of a_k, b_k and B that of the other a, b, products that underflow add to the error at most (A (B + 1) + 1)
// 2^-1072. Where one arrow begins at the end of the other, that point is the corner.
inline Sign corner_side(const LeftOf& i, const LeftOf& j, const LeftOf& k, StageTally* tally) {
  if (i.to == j.from || i.from == j.to) return -orient_2d(k.from, k.to, i.to == j.from ? i.to : i.from, tally);
  const Point2& o = k.from;
  const double ai = i.to.y - i.from.y, bi = i.from.x - i.to.x, aj = j.to.y - j.from.y, bj = j.from.x - j.to.x;
  const double ak = k.to.y - k.from.y, bk = k.from.x - k.to.x;
  const double xi = ai * (i.from.x - o.x), yi = bi * (i.from.y - o.y), ci = xi + yi;
  const double xj = aj * (j.from.x - o.x), yj = bj * (j.from.y - o.y), cj = xj + yj;
  const double value = ak * (ci * bj - cj * bi) + bk * (ai * cj - aj * ci);
  const double size_i = std::fabs(xi) + std::fabs(yi), size_j = std::fabs(xj) + std::fabs(yj);
  const double a = std::fabs(ak), b = std::fabs(bk);
  const double size =
      a * (size_i * std::fabs(bj) + size_j * std::fabs(bi)) + b * (std::fabs(ai) * size_j + std::fabs(aj) * size_i);
  const double others = (std::fabs(ai) + std::fabs(bi)) + (std::fabs(aj) + std::fabs(bj));
  const double error = Rounded<10>::bound * size + 0x1p-1020 * ((a + b) * (others + 1) + 1);
  if (value > error || value < -error)
    return counted(&StageTally::rounded, tally, value > 0 ? Sign::positive : Sign::negative);
  return corner_side_further(i, j, k, tally);
}

}  // namespace sunder
