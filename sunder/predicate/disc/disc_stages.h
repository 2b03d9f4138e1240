// How a predicate on discs runs through its stages: as decide (see stages.h), for formulas of up to eight factors. For
// use inside predicate/ and its tests.
//
// A stage's disc is a Vector3: x and y of the centre, and the radius as z.
#pragma once

#include <sunder/number/double_double.h>
#include <sunder/predicate/disc/disc.h>
#include <sunder/predicate/filter/stages.h>

#include <algorithm>
#include <cmath>

namespace sunder {

template <class Stage>
auto lift(const Disc& d) {
  return lift<Stage>(Point3{d.center.x, d.center.y, d.radius});
}

// Numbers of at most 2^60 in size: sums of two are at most 2^61, products of seven such sums at most 2^427, and a
// product that underflows is off by at most 2^-1075. So in a formula of up to eight factors and 1,000 products
// underflow adds less than 2^-638 to the error: a value or magnitude has to be larger than `underflow_floor` to tell a
// sign.
inline bool is_moderate(const Disc& d) {
  return std::max(std::max(std::fabs(d.center.x), std::fabs(d.center.y)), d.radius) <= 0x1p60;
}

// Floating point, with its error bound and underflow looked after.
template <int K>
struct Floored {
  Rounded<K> number;
};
inline constexpr double underflow_floor = 0x1p-630;

template <int K>
Floored(Rounded<K>) -> Floored<K>;

template <int J, int K>
auto operator+(const Floored<J>& a, const Floored<K>& b) {
  return Floored{a.number + b.number};
}
template <int J, int K>
auto operator-(const Floored<J>& a, const Floored<K>& b) {
  return Floored{a.number - b.number};
}
template <int J, int K>
auto operator*(const Floored<J>& a, const Floored<K>& b) {
  return Floored{a.number * b.number};
}
template <int K>
Guess sign(const Floored<K>& x) {
  const double error = Rounded<K>::bound * x.number.magnitude + underflow_floor;
  if (x.number.value > error) return Guess::positive;
  if (x.number.value < -error) return Guess::negative;
  return Guess::unsure;
}

struct FlooredStage {
  static Floored<0> read(double x) { return {leaf(x)}; }
};

// The same with numbers of 106 bits (see number/double_double.h), of which an operation is off by at most 2^-103 of its
// result: with that in the place of u the bound is that of Rounded. For what is nearly a tie and none.
template <int K>
struct Fine {
  DoubleDouble value;
  double magnitude;
  static constexpr double bound = (K + 2) * 0x1p-103;
};
template <int J, int K>
Fine<sum_roundings<J, K>> operator+(const Fine<J>& a, const Fine<K>& b) {
  return {a.value + b.value, a.magnitude + b.magnitude};
}
template <int J, int K>
Fine<sum_roundings<J, K>> operator-(const Fine<J>& a, const Fine<K>& b) {
  return {a.value - b.value, a.magnitude + b.magnitude};
}
template <int J, int K>
Fine<J + K + 1> operator*(const Fine<J>& a, const Fine<K>& b) {
  return {a.value * b.value, a.magnitude * b.magnitude};
}
template <int K>
Guess sign(const Fine<K>& x) {
  const double error = Fine<K>::bound * x.magnitude + underflow_floor;
  if (x.value.high > error) return Guess::positive;
  if (x.value.high < -error) return Guess::negative;
  return Guess::unsure;
}

struct FineStage {
  static Fine<0> read(double x) { return {x, std::fabs(x)}; }
};

// The sign that formula(discs...) guesses, by the first stage that is sure. The second one is intervals, or, for
// moderate discs, numbers of 106 bits; it is counted as intervals.
template <class Formula, class... Discs>
Sign decide_discs(StageTally* tally, const Formula& formula, const Discs&... discs) {
  const bool moderate = (is_moderate(discs) && ...);
  if (moderate) {
    const Guess guess = formula(lift<FlooredStage>(discs)...);
    if (is_sure(guess)) return counted(&StageTally::rounded, tally, to_sign(guess));
  }
  const Guess guess = moderate ? formula(lift<FineStage>(discs)...) : formula(lift<IntervalStage>(discs)...);
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, to_sign(formula(lift<ExactStage>(discs)...)));
}

// Seen from the centre of disc i: the centre of disc k.
template <class A, class B>
auto center_from(const A& i, const B& k) {
  const auto x = k.x - i.x;
  return Vector2<decltype(k.y - i.y)>{x, k.y - i.y};
}

// The power of disc k at the centre of disc i, minus that of i itself: |way|^2 + r_i^2 - r_k^2.
template <class A, class B>
auto lead(const A& i, const B& k) {
  const auto to_k = center_from(i, k);
  return dot(to_k, to_k) + (i.z - k.z) * (i.z + k.z);
}

// Sixteen times the squared area of the triangle of the two centres and a crossing of the circles; 4 |way|^2 r_i^2
// minus the square of lead(i, k). Negative where the circles have no common point.
template <class A, class B>
auto crossing_area(const A& i, const B& k) {
  const auto to_k = center_from(i, k);
  const auto distance = dot(to_k, to_k);
  const auto sum = i.z + k.z;
  const auto difference = i.z - k.z;
  return (sum * sum - distance) * (distance - difference * difference);
}

}  // namespace sunder
