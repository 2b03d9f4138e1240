// The other libraries of bench_polygons behind one interface.
//
// Every library prepares polygons of its own outside of the timed loop, and indexes where it offers any. It is asked
// for a boolean only. Of each library the fastest way that is right counts.
#pragma once

#include <bench/contest/contest.h>
#include <bench/inputs/polygon_scenarios.h>

#include <cstdint>
#include <exception>
#include <string_view>
#include <utility>
#include <vector>

namespace bench {

inline constexpr std::uint64_t kNoAnswer = 2;  // it threw

// ask(pair) answers one pair, as bool.
template <class Ask>
Run run_over(const PolygonScenario& scenario, Ask ask) {
  return each([&pairs = scenario.pairs, ask = std::move(ask)](std::size_t k) mutable -> std::uint64_t {
    try {
      return ask(pairs[k]) ? 1 : 0;
    } catch (const std::exception&) {
      return kNoAnswer;
    }
  });
}

struct PolygonWay {
  std::string_view library, method;
  Run (*make)(const PolygonScenario&);  // the scenario outlives it
};

// Boost.Geometry (plain doubles): intersects, of rings and of polygons.
std::vector<PolygonWay> boost_polygon_ways();

// GEOS, through its C interface: GEOSIntersects, and GEOSPreparedIntersects with the first polygon prepared, its index
// built before the loop.
std::vector<PolygonWay> geos_polygon_ways();

// CGAL:
//   do_intersect of Polygon_2. It asks whether interiors meet, so that polygons that touch do not. It constructs
//   points:
//     with exact ones, since with rounded ones it crashes on polygons that touch.
//   box_intersection_d of the boxes of the edges (prepared), each pair of edges then decided exactly, to the first that
//     meet; where none do, whether a vertex of one is in the other.
std::vector<PolygonWay> cgal_polygon_ways();

}  // namespace bench
