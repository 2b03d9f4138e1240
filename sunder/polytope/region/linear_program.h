// Which points of N half-spaces of R^d, 2 <= d <= 6, are furthest along a direction c: the linear program "maximize
// c . x, where a . x <= b"?
// In the plane, with half-planes that are named by number alone: planar/region/linear_program.h.
// Also called: linear programming (LP) in fixed dimension.
//
// The answer is exactly right for the doubles given, whatever the position, and stands by itself:
//   L1. All methods give the same outcome, and of `one` the same point. Evidence may differ.
//   L2. check() accepts the answer.
//   L3. The answer does not depend on the compiler.
// Requires: a polytope of half-spaces, an objective of as many finite numbers as it has dimensions. None throws, but
// for want of memory.
// Source: Seidel 1991; Shamos & Hoey 1976, section V and problem VI.9, which ask for three variables.
#pragma once

#include <sunder/certificate/optimum.h>
#include <sunder/polytope/pair/evidence.h>

#include <span>
#include <variant>
#include <vector>

namespace sunder::polytope {

// The evidence, one for each outcome (certificate/optimum.h). Numbers are exact; a point is `numbers` over its
// denominator, which is positive; multipliers, of rows (a, b), are positive.

// The sum of the a is c, and that of the b is c . point; the normals span R^d. At most 2 d rows.
struct OneOptimum {
  static constexpr Optimum verdict = Optimum::one;
  ExactPointN point{};
  Weights multipliers{};
};

// The sum of the a is c, and that of the b is c . point; another point is as good. At most d rows.
struct ManyOptima {
  static constexpr Optimum verdict = Optimum::many;
  ExactPointN point{}, other{};
  Weights multipliers{};
};

// c = 0: a common point.
struct AnyPoint {
  static constexpr Optimum verdict = Optimum::all;
  ExactPointN point{};
};

// A common point, and a direction in which one never leaves, and gets further.
struct NoBound {
  static constexpr Optimum verdict = Optimum::unbounded;
  ExactPointN point{};
  std::vector<Dyadic> direction{};
};

// The sum of the a is zero, and that of the b negative. At most d + 1 rows.
struct NoPoint {
  static constexpr Optimum verdict = Optimum::infeasible;
  Weights multipliers{};
};

using ProgramEvidence = std::variant<OneOptimum, ManyOptima, AnyPoint, NoBound, NoPoint>;

// What the evidence has of these: a point that is best, or a common one; multipliers. Else null.
const ExactPointN* named_point(const ProgramEvidence& evidence);
const Weights* named_multipliers(const ProgramEvidence& evidence);

// Decided by `finishing`: the search's basis was not the last one. Cost: probes: rows looked at; iterations: pivots;
// proposals: one; exact: signs that needed exact arithmetic.
using LinearProgramAnswer = Answer<ProgramEvidence>;

// The front door: a search in floating point by the dual simplex method, whose next row is the one that is broken most,
// found by a scan; its basis is checked in exact numbers, and where it is not the last one, the method goes on in
// integers, to its end. Objectives are perturbed symbolically, so it ends whatever the degeneracy; and half-spaces lie
// in a box, symbolically as great as one likes, so that no outcome is a special case.
// Cost: some 2 d to 5 d scans. Allocates.
LinearProgramAnswer linear_program(const Polytope& half_spaces, std::span<const double> objective);

// Half-spaces in random order, from a fixed seed; where the optimum so far is outside of the next one, it is found anew
// on that one's hyperplane, a program of one dimension less. In floating point; its basis is checked, and finished, as
// above.
// Cost: O(d! N) expected rows.
LinearProgramAnswer linear_program_by_seidel(const Polytope& half_spaces, std::span<const double> objective);

// The oracle: a full tableau in integers with Bland's rule, for the optimum, and then for the least and greatest
// coordinates of best points. It shares nothing with the above.
LinearProgramAnswer linear_program_by_scan(const Polytope& half_spaces, std::span<const double> objective);

// Is the answer what it says it is, by its evidence alone? Nothing of a search is used. Cost: linear, exact arithmetic.
bool check(const Polytope& half_spaces, std::span<const double> objective, const LinearProgramAnswer& answer);

}  // namespace sunder::polytope
