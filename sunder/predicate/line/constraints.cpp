#include <sunder/base/contract.h>
#include <sunder/number/double_double.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/interval.h>
#include <sunder/predicate/line/constraints.h>

#include <cstdint>

namespace sunder {

namespace {

template <class T>
struct Lifted {
  T a, b, c;
};

// As seen from the origin; constraints always are.
template <class T>
Lifted<T> lifted(const Constraint& i, const Constraint&) {
  return {T(i.a), T(i.b), T(i.c)};
}

// As seen from where k begins.
template <class T>
Lifted<T> lifted(const LeftOf& i, const LeftOf& k) {
  const T a = T(i.to.y) - T(i.from.y), b = T(i.from.x) - T(i.to.x);
  if (i.from == k.from) return {a, b, T(0.0)};
  return {a, b, a * (T(i.from.x) - T(k.from.x)) + b * (T(i.from.y) - T(k.from.y))};
}

template <class T>
T corner_formula(const Lifted<T>& i, const Lifted<T>& j, const Lifted<T>& k) {
  return k.a * (i.c * j.b - j.c * i.b) + k.b * (i.a * j.c - j.a * i.c) - k.c * (i.a * j.b - i.b * j.a);
}

template <class T, class Half>
T corner_formula(const Half& i, const Half& j, const Half& k) {
  return corner_formula<T>(lifted<T>(i, k), lifted<T>(j, k), lifted<T>(k, k));
}

// Intervals, then exact numbers, for formulas over T = Interval, Dyadic.
template <class Formula>
Sign decide_further(StageTally* tally, const Formula& formula) {
  const Guess guess = sign(formula(Interval()));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, formula(Dyadic()).sign());
}

template <class Half>
Sign corner_side_in_general(const Half& i, const Half& j, const Half& k, StageTally* tally) {
  return decide_further(tally, [&](const auto& zero) { return corner_formula<std::decay_t<decltype(zero)>>(i, j, k); });
}

// Whole numbers of moderate size: their sums, differences and products are exact in doubles up to 2^53.
bool is_whole(double x) { return std::fabs(x) < 0x1p52 && x == static_cast<double>(static_cast<std::int64_t>(x)); }
bool is_whole(const Constraint& i) { return is_whole(i.a) && is_whole(i.b) && is_whole(i.c); }
bool is_whole(const LeftOf& i) {
  return is_whole(i.from.x) && is_whole(i.from.y) && is_whole(i.to.x) && is_whole(i.to.y);
}

// A double with a bound on the size of all that it was made of.
struct Whole {
  double value, size;
  explicit Whole(double x) : value(x), size(std::fabs(x)) {}
  Whole(double v, double s) : value(v), size(s) {}
  friend Whole operator+(const Whole& x, const Whole& y) { return {x.value + y.value, x.size + y.size}; }
  friend Whole operator-(const Whole& x, const Whole& y) { return {x.value - y.value, x.size + y.size}; }
  friend Whole operator*(const Whole& x, const Whole& y) { return {x.value * y.value, x.size * y.size}; }
};

// The formula with the row of i taken from the others, which leaves it as it is: the rows of lines that are nearly the
// same have small differences. As a Rounded<7>, with underflow as in the first stage.
Guess corner_side_by_differences(const Constraint& i, const Constraint& j, const Constraint& k) {
  const double ua = j.a - i.a, ub = j.b - i.b, uc = j.c - i.c, wa = k.a - i.a, wb = k.b - i.b, wc = k.c - i.c;
  const double cb = uc * wb, bc = ub * wc, ac = ua * wc, ca = uc * wa, ab = ua * wb, ba = ub * wa;
  const double value = i.a * (cb - bc) + i.b * (ac - ca) - i.c * (ab - ba);
  const double a = std::fabs(i.a), b = std::fabs(i.b), c = std::fabs(i.c);
  const double size =
      a * (std::fabs(cb) + std::fabs(bc)) + b * (std::fabs(ac) + std::fabs(ca)) + c * (std::fabs(ab) + std::fabs(ba));
  const double error = Rounded<7>::bound * size + 0x1p-1020 * (a + b + c + 1);
  return value > error ? Guess::positive : value < -error ? Guess::negative : Guess::unsure;
}
Guess corner_side_by_differences(const LeftOf&, const LeftOf&, const LeftOf&) { return Guess::unsure; }

// Numbers with which products of four, or of sums of them, neither overflow nor underflow in pairs of doubles: they are
// multiples of 2^-202, so products are multiples of 2^-808.
bool is_middling(double x) { return x == 0 || (std::fabs(x) >= 0x1p-150 && std::fabs(x) <= 0x1p200); }
bool is_middling(const Constraint& i) { return is_middling(i.a) && is_middling(i.b) && is_middling(i.c); }
bool is_middling(const LeftOf& i) {
  return is_middling(i.from.x) && is_middling(i.from.y) && is_middling(i.to.x) && is_middling(i.to.y);
}

// A pair of doubles and the size of the terms it is the sum of. An operation is off by at most 2^-102 of its result
// (number/double_double.h): of the formula at most 12 are upon each other.
struct Precise {
  DoubleDouble value;
  double size;
  explicit Precise(double x) : value(x), size(std::fabs(x)) {}
  Precise(const DoubleDouble& v, double s) : value(v), size(s) {}
  friend Precise operator+(const Precise& x, const Precise& y) { return {x.value + y.value, x.size + y.size}; }
  friend Precise operator-(const Precise& x, const Precise& y) { return {x.value - y.value, x.size + y.size}; }
  friend Precise operator*(const Precise& x, const Precise& y) { return {x.value * y.value, x.size * y.size}; }
};
constexpr double precise_bound = 0x1p-97;

// Differences of coordinates are exact in pairs of doubles: their own size serves.
template <>
Lifted<Precise> lifted<Precise>(const LeftOf& i, const LeftOf& k) {
  const auto difference = [](double x, double y) {
    const DoubleDouble exact = exact_sum(x, -y);
    return Precise(exact, std::fabs(exact.high));
  };
  const Precise a = difference(i.to.y, i.from.y), b = difference(i.from.x, i.to.x);
  return {a, b, a * difference(i.from.x, k.from.x) + b * difference(i.from.y, k.from.y)};
}

template <class Half>
Sign corner_side_by_stages(const Half& i, const Half& j, const Half& k, StageTally* tally) {
  if (k == i || k == j) return counted(&StageTally::rounded, tally, Sign::zero);
  const Guess guess = corner_side_by_differences(i, j, k);
  if (is_sure(guess)) return counted(&StageTally::rounded, tally, to_sign(guess));
  if (is_whole(i) && is_whole(j) && is_whole(k)) {
    const Whole whole = corner_formula<Whole>(i, j, k);
    if (whole.size <= 0x1p53) return counted(&StageTally::exact, tally, sign_of(whole.value));
  }
  if (is_middling(i) && is_middling(j) && is_middling(k)) {
    const Precise precise = corner_formula<Precise>(i, j, k);
    const double error = precise_bound * precise.size;
    if (precise.value.high > error) return counted(&StageTally::interval, tally, Sign::positive);
    if (precise.value.high < -error) return counted(&StageTally::interval, tally, Sign::negative);
  }
  return corner_side_in_general(i, j, k, tally);
}

// By Cramer's rule, the denominator made positive; the coefficients are as seen from the origin.
ExactPoint2 corner_of(const ExactConstraint& i, const ExactConstraint& j) {
  ExactPoint2 corner{i.c * j.b - j.c * i.b, i.a * j.c - j.a * i.c, i.a * j.b - i.b * j.a};
  if (corner.denominator.sign() == Sign::negative) corner = {-corner.x, -corner.y, -corner.denominator};
  return corner;
}

}  // namespace

Sign offsets_further(double c, double d, double e, double f, StageTally* tally) {
  const Guess guess = sign_of_exact_differences(c, 0, d, 0, e, 0, f, 0);
  if (is_sure(guess)) return counted(&StageTally::exact, tally, to_sign(guess));
  return decide_further(tally, [&](const auto& zero) {
    using T = std::decay_t<decltype(zero)>;
    return T(c) * T(d) + T(e) * T(f);
  });
}

Sign corner_side_further(const Constraint& i, const Constraint& j, const Constraint& k, StageTally* tally) {
  return corner_side_by_stages(i, j, k, tally);
}
Sign corner_side_further(const LeftOf& i, const LeftOf& j, const LeftOf& k, StageTally* tally) {
  return corner_side_by_stages(i, j, k, tally);
}

ExactConstraint exact_constraint(const Constraint& i) { return {i.a, i.b, i.c}; }
ExactConstraint exact_constraint(const LeftOf& i) {
  const Dyadic a = Dyadic(i.to.y) - Dyadic(i.from.y), b = Dyadic(i.from.x) - Dyadic(i.to.x);
  return {a, b, a * Dyadic(i.from.x) + b * Dyadic(i.from.y)};
}

ExactPoint2 exact_corner(const Constraint& i, const Constraint& j) {
  SUNDER_REQUIRE(turn(i, j) != Sign::zero);
  return corner_of(exact_constraint(i), exact_constraint(j));
}
ExactPoint2 exact_corner(const LeftOf& i, const LeftOf& j) {
  SUNDER_REQUIRE(turn(i, j) != Sign::zero);
  return corner_of(exact_constraint(i), exact_constraint(j));
}

ExactPoint2 exact_point_on(const Constraint& i) {
  const auto [a, b, c] = exact_constraint(i);
  return {a * c, b * c, a * a + b * b};
}
ExactPoint2 exact_point_on(const LeftOf& i) { return {i.from.x, i.from.y, 1.0}; }

}  // namespace sunder
