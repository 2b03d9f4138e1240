// How a predicate runs through its stages: one formula, three number types. For use inside predicate/ and its tests.
// Also called: filtered predicate; arithmetic filter; adaptive, exact geometric computation.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/interval.h>
#include <sunder/number/rounded.h>
#include <sunder/number/sign.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/posed.h>

namespace sunder {

// The three number types: how each reads a double.
struct RoundedStage {
  static Rounded<0> read(double x) { return leaf(x); }
};
using IntervalStage = NumberStage<Interval>;
using ExactStage = NumberStage<Dyadic>;

// Is the floating-point stage free of underflow for formulas of up to three factors?
inline bool is_tame(const Point3& p) { return tame(p.x) && tame(p.y) && tame(p.z); }
inline bool is_tame(const Posed3& p) { return p.tame; }
inline bool is_tame(const Point2& p) { return tame(p.x) && tame(p.y); }
inline bool is_tame(const Posed2& p) { return p.tame; }

// The sign of formula(points...), by the first stage that is sure.
template <class Formula, class... Points>
Sign decide(StageTally* tally, const Formula& formula, const Points&... points) {
  if ((is_tame(points) && ...)) {
    const Guess guess = sign(formula(lift<RoundedStage>(points)...));
    if (is_sure(guess)) return counted(&StageTally::rounded, tally, to_sign(guess));
  }
  const Guess guess = sign(formula(lift<IntervalStage>(points)...));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, formula(lift<ExactStage>(points)...).sign());
}

// The formulas.

inline constexpr auto orient_3d_formula = [](const auto& a, const auto& b, const auto& c, const auto& d) {
  return dot(cross(b - a, c - a), d - a);
};

template <int Axis>
inline constexpr auto orient_2d_formula = [](const auto& a, const auto& b, const auto& c) {
  const auto u = b - a;
  const auto v = c - a;
  if constexpr (Axis == 0) return u.y * v.z - u.z * v.y;
  if constexpr (Axis == 1) return u.z * v.x - u.x * v.z;
  if constexpr (Axis == 2) return u.x * v.y - u.y * v.x;
};

template <int Axis>
inline constexpr auto difference_formula = [](const auto& a, const auto& b) {
  if constexpr (Axis == 0) return b.x - a.x;
  if constexpr (Axis == 1) return b.y - a.y;
  if constexpr (Axis == 2) return b.z - a.z;
};

}  // namespace sunder
