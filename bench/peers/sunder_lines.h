// The library under test in bench_lines, asked as its peers are.
#pragma once

#include <bench/contest/contest.h>
#include <bench/inputs/line_scenarios.h>

#include <cstdint>

namespace bench {

// Scenarios outlive what is made of them. Bodies are prepared, with what their first question makes.

// front_door: the features through which the line goes in and out, exactly. ends: the nearest doubles of both ends
// besides, by exact arithmetic. drums: polyhedron_line_by_drums.
// The tally compares the kind of each answer and its exact ends with the truth, and of the front door some answers,
// fewer of large bodies, with those of the scan, feature by feature.
enum class LineBy : std::uint8_t { front_door, ends, drums };
Ready prepare_sunder(const LineScenario&, LineBy);

// corners: polyhedron_plane_section, and its corners as nearest doubles. names: without these. stack: all planes, which
// are parallel, in one call of polyhedron_plane_sections; with corners.
enum class SectionBy : std::uint8_t { corners, names, stack };
Ready prepare_sunder(const SectionScenario&, SectionBy);

// Which side of a plane: polyhedron_plane, _by_drums, _by_scan.
enum class SideBy : std::uint8_t { front_door, drums, scan };
Ready prepare_sunder(const SideScenario&, SideBy);

// Does a flat polygon meet the body: polyhedron_polyhedron, polyhedron_polygon_by_drums, _by_scan.
enum class PolygonBy : std::uint8_t { front_door, drums, scan };
Ready prepare_sunder(const PolygonScenario&, PolygonBy);

}  // namespace bench
