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

#include <sunder/polytope/pair/evidence.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace sunder::polytope {

enum class Optimum : std::uint8_t {
  one,         // one point is best
  many,        // more than one
  all,         // c = 0: each common point
  unbounded,   // common points are as far as one likes
  infeasible,  // no common point
};

std::string_view name_of(Optimum);  // "infeasible"

// Numbers are exact; a point is `numbers` over its denominator, which is positive.
struct [[nodiscard]] LinearProgramAnswer {
  Optimum outcome = Optimum::infeasible;
  // A point that is best; of `all` and `unbounded` a common one; empty where there is none.
  ExactPointN point{};
  // many: another one that is as good. Else empty.
  ExactPointN other{};
  // unbounded: a direction in which one never leaves, and gets further. Else empty.
  std::vector<Dyadic> direction{};
  // Positive multipliers of rows (a, b). one, many: the sum of the a is c, and that of the b is c . point; of `one` the
  // normals span R^d. infeasible: the sum of the a is zero, and that of the b negative. Else none. `many` and
  // `infeasible` name d and d + 1 rows at most, `one` 2 d.
  Weights multipliers{};
  DecidedBy decided_by = DecidedBy::evidence;  // finishing: the search's basis was not the last one
  Cost cost;  // probes: rows looked at; iterations: pivots; proposals: one; exact: signs that needed exact arithmetic

  bool feasible() const { return outcome != Optimum::infeasible; }
};

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
