// Which points of N half-planes are furthest in a direction (p, q): the linear program "maximize p x + q y"?
// Also called: linear programming (LP) in two variables.
//
// The answer is exactly right for the doubles given, whatever the position, and comes with its evidence, which names
// half-planes by number. Angles are those of normals, counter-clockwise; a half-plane's line runs counter-clockwise
// too: with the half-plane on its left, that is, its normal on its right.
//   L1. All methods give the same outcome, and the same optimal points. The half-planes named may differ.
//   L2. check() accepts the answer.
//   L3. The answer does not depend on the compiler.
// None throws, but for want of memory. `Given` is Constraints or HalfPlanes.
// Source: Shamos & Hoey 1976, section V, Theorems 11 and 12, and the remark on many objectives after it.
// Departure: Theorem 12 makes the region first, in O(N log N); here Seidel's method (1991) and sampling (Clarkson 1995)
// take O(N) expected. by_region is the remark.
#pragma once

#include <sunder/certificate/optimum.h>
#include <sunder/planar/region/region.h>
#include <sunder/planar/region/side_table.h>

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace sunder::planar {

inline constexpr std::uint32_t no_half_plane = 0xffffffffu;

// The evidence, one for each outcome (certificate/optimum.h): numbers of half-planes. Those that may be no_half_plane
// begin as it.

// The corner of before and after, whose normals turn, less than a half turn, from one side of (p, q) to the other; or
// where there is a side, whose normal is in the direction (p, q): the corner of before and side, through which the line
// of after goes.
struct OneOptimum {
  static constexpr Optimum verdict = Optimum::one;
  std::uint32_t before = 0, after = 0, side = no_half_plane;
};

// The points of the line of `side`, whose normal is in the direction (p, q), from its corner with before to that with
// after; where there is none of these, without end there.
struct ManyOptima {
  static constexpr Optimum verdict = Optimum::many;
  std::uint32_t side = 0, before = no_half_plane, after = no_half_plane;
};

// p = q = 0. A common point: the corner of before and after; where there is no after, all lines are parallel to that of
// before, and each of its points is one; where there is no before either, there are no half-planes. (How many common
// points there are, the kind of the region tells.)
struct AnyPoint {
  static constexpr Optimum verdict = Optimum::all;
  std::uint32_t before = no_half_plane, after = no_half_plane;
};

// A common point, and a direction in which one never leaves: that of the line of `side`, or its opposite; where there
// is no side, (p, q).
struct NoBound {
  static constexpr Optimum verdict = Optimum::unbounded;
  AnyPoint from;
  std::uint32_t side = no_half_plane;
  bool backward = false;  // the opposite
};

// Before, side, after follow each other counter-clockwise, and have no common point; where there is no side, before and
// after have none.
struct NoPoint {
  static constexpr Optimum verdict = Optimum::infeasible;
  std::uint32_t before = 0, after = 0, side = no_half_plane;
};

using ProgramEvidence = std::variant<OneOptimum, ManyOptima, AnyPoint, NoBound, NoPoint>;

// Cost: probes: signs that were asked for; exact: those that needed exact arithmetic.
using LinearProgramAnswer = Answer<ProgramEvidence>;

// A point that is best, of `unbounded` a common one. Requires other evidence than NoPoint.
AnyPoint named_point(const ProgramEvidence& evidence);

// The direction; both numbers finite.
struct Objective {
  double p = 0, q = 0;
};

// The front door: the fastest method measured, by sampling. Cost: O(N) expected signs.
template <class Given>
LinearProgramAnswer linear_program(const Given& given, const Objective& objective);

// Half-planes in random order, from a fixed seed; where the optimum so far is outside of the next one, it is found anew
// on that one's line. Cost: O(N) expected signs.
template <class Given>
LinearProgramAnswer linear_program_by_seidel(const Given& given, const Objective& objective);

// By Seidel for a random sample, to which those that do not hold its optimum are added, until there are none: at most
// four rounds. Cost: O(N) expected signs; half-planes are looked at in their order in memory.
template <class Given>
LinearProgramAnswer linear_program_by_sampling(const Given& given, const Objective& objective);

// For many objectives: `region` is the common part of the half-planes. Cost: O(log N) signs; allocates nothing while
// filters decide.
template <class Given>
LinearProgramAnswer linear_program_by_region(const Given& given, const Region& region, const Objective& objective);

// A region with its sides in a row, and a table of their angles: for very many objectives. It keeps references to both.
// Immutable; any number of threads may use it. Cost: O(sides) to make.
template <class Given>
class PreparedRegion {
 public:
  using Half = typename Given::Half;
  struct Side {
    Half half;
    std::uint32_t number;  // of the half-plane
  };

  PreparedRegion(const Given& given, const Region& region)
      : given_(given), region_(region), buckets_(SideTable::keys_of(given, region.sides)) {
    sides_.reserve(region.sides.size());
    for (const std::uint32_t side : region.sides) sides_.push_back({given[side], side});
  }

  const Given& given() const { return given_; }
  const Region& region() const { return region_; }
  std::span<const Side> sides() const { return sides_; }

  // The positions of sides of nearly the same angle.
  AngleBuckets::Range around(const Half& half) const { return buckets_.around(side_table_detail::key_of(half)); }

 private:
  const Given& given_;
  const Region& region_;
  AngleBuckets buckets_;
  std::vector<Side> sides_;
};

// The same; a table of angles proposes where to search, so that two places in memory are read. Cost: O(1) signs for
// sides' angles spread evenly, O(log N) at worst.
template <class Given>
LinearProgramAnswer linear_program_by_region(const PreparedRegion<Given>& region, const Objective& objective);

// Every corner: the oracle. O(N^3) signs.
template <class Given>
LinearProgramAnswer linear_program_by_scan(const Given& given, const Objective& objective);

// A point that is optimal, for `unbounded` a common one. Requires a feasible answer. Cost: exact arithmetic.
template <class Given>
ExactPoint2 point_of(const Given& given, const LinearProgramAnswer& answer);

// Is the answer what it says it is, by its evidence alone? Nothing of a search is used. Cost: O(N) signs.
template <class Given>
bool check(const Given& given, const Objective& objective, const LinearProgramAnswer& answer);

}  // namespace sunder::planar
