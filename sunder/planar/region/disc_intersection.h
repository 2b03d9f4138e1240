// What is the common part of N closed discs?
// Also called: intersection of disks.
//
// The answer is exactly right for the doubles given, whatever the position: equal, concentric and nested discs, circles
// that touch from inside or outside, many through one point, radius zero, barely empty or barely not.
//   C1. Kind and arcs are determined by the discs: all methods give the same.
//   C2. Each arc is more than a point. Two that follow each other are of different discs.
//   C3. Of equal discs the lowest number is named.
//   C4. The answer does not depend on the compiler.
// Evidence: the deepest point (discs_deepest.h), for each kind. Its discs prove an empty part or name the only point;
// of a region it is a point inside of all discs, and with it the arcs are checked (disc_intersection_claims.h). An arc
// of a small disc may come several times; arcs are fewer than 2 N. No function throws unless memory runs out. Source:
// Shamos & Hoey 1976, section V, Theorem 13.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/base/cost.h>
#include <sunder/planar/object/discs.h>
#include <sunder/planar/region/discs_deepest.h>
#include <sunder/predicate/disc/disc_crossing.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::planar {

enum class DiscIntersectionKind : std::uint8_t {
  empty,
  point,
  region,
  plane,  // of no discs
};

std::string_view name_of(DiscIntersectionKind);  // "region"

struct [[nodiscard]] DiscIntersection {
  DiscIntersectionKind kind = DiscIntersectionKind::plane;

  // region: the discs whose arcs bound it, counter-clockwise, beginning so that the list is lexicographically least.
  // One is a whole disc. Arc m goes from corner m - 1 to corner m.
  std::vector<std::uint32_t> arcs;

  DeepestPoint deepest;  // meaningless for `plane`
  Cost cost;             // probes: discs compared with a point or box, and pairs of circles compared in a sector
};

// Corner m: where arc m ends and the next one begins. Requires two arcs.
inline DiscCrossing corner(const Discs& circles, const DiscIntersection& part, std::size_t m) {
  SUNDER_REQUIRE(part.arcs.size() > 1 && m < part.arcs.size());
  const std::uint32_t a = part.arcs[m], b = part.arcs[m + 1 == part.arcs.size() ? 0 : m + 1];
  return {circles[a], circles[b]};
}

// The front door: the fastest method measured, by batches. Cost: as disc_intersection_by_batches.
DiscIntersection disc_intersection(const Discs& circles);

// The common parts of both halves of the discs are merged, as functions of the direction seen from the deepest point.
// Cost: O(N log N) probes, expected; O(N) memory.
// Departure: the paper has parts of halves merged as figures, which may be empty or a point; seen from a point inside
// of all, no such case is left, and each direction has one boundary point of each part.
DiscIntersection disc_intersection_by_division(const Discs& circles);

// Discs in random order, batches that double: those that hold a box around the common part so far are done with, the
// others are merged as by division. Cost: as by division at most; O(N) where few discs bound each part.
DiscIntersection disc_intersection_by_batches(const Discs& circles);

// The oracle: every crossing of two circles against all discs. O(N^3) signs.
DiscIntersection disc_intersection_by_scan(const Discs& circles);

}  // namespace sunder::planar
