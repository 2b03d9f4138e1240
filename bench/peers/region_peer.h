// The other library of bench_regions behind one interface.
//
// Half-planes, polygons and discs are prepared outside of the timed loop, as Sunder's are. A way of asking is right on
// an input where it gives the number of sides that is known, or the half-planes that meet at the optimum.
#pragma once

#include <bench/inputs/region_scenarios.h>
#include <bench/peers/segment_peer.h>

#include <string_view>
#include <vector>

namespace bench {

struct RegionWay {
  std::string_view library, method;
  // Prepares the input; empty where the way does not answer the question. The input outlives it.
  Asked (*make)(const RegionInput&);
};

// The common part of half-planes, convex polygons or discs. Answers are numbers of sides.
//   intersection, of the range, and of pairs, pairs of these, and so on: polygons, and discs as general polygons. (Two
//     arcs of one circle that follow each other are one side: CGAL parts them where the circle turns back.)
//   convex_hull_2 of the polar points, exact, and rounded to doubles: half-planes, and polygons by their edges. CGAL
//     has no common part of half-planes in the plane; this is what it has next to it, and it wants a point inside,
//     which it is given: the origin. So it does not answer the same question, and is a library of its own, "hull".
std::vector<RegionWay> cgal_region_ways();

struct Objective {
  double x = 0, y = 0;
};

// Which two half-planes meet at the optimum? max * 2^32 + min of their numbers. By solve_linear_program, which is
// exact.
Asked cgal_linear_program(const RegionInput& input, const Objective& objective);

inline std::uint64_t pair_of(std::uint32_t i, std::uint32_t j) {
  return i < j ? (std::uint64_t{j} << 32) + i : (std::uint64_t{i} << 32) + j;
}

}  // namespace bench
