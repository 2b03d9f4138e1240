// The other libraries of bench_lines behind one interface.
//
// Every library prepares meshes, trees and queries of its own outside of the timed loop. About a line it is asked where
// it goes in and where it goes out, about a plane for the closed line of the section with its corners.
#pragma once

#include <bench/contest/contest.h>
#include <bench/inputs/line_scenarios.h>

#include <string_view>
#include <vector>

namespace bench {

struct LineWay {
  std::string_view library, method;
  Run (*make)(const LineScenario&);  // the scenario outlives it; gives LineQuery::answer
};

struct SectionWay {
  std::string_view library, method;
  Run (*make)(const SectionScenario&);  // the scenario outlives it; gives the number of corners
};

// CGAL's AABB tree of triangles:
//   all_intersections of the line, and of these the first and the last.
//   first_intersection of two rays, from outside to both sides.
// Each in plain doubles (Simple_cartesian), and with exact signs (Epick).
std::vector<LineWay> cgal_line_ways();

// CGAL's Polygon_mesh_slicer, with its tree of edges made before: with exact signs (Epick), and in plain doubles.
std::vector<SectionWay> cgal_section_ways();

// Embree in single precision: two rays, rtcIntersect1 from outside to both sides; with and without its robust mode.
std::vector<LineWay> embree_line_ways();

// A loop over all vertices in doubles, without any bound: do they lie on both sides of the plane?
Run scan_in_doubles(const SideScenario& scenario);

}  // namespace bench
