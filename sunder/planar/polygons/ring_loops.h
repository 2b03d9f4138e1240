// Rings cut where they touch themselves, and how these loops lie within each other. For use by polygon_valid.
//
// A ring that touches itself, and does not cross itself, is cut there: of all that it does between two visits of a
// point a loop is made, so that each loop visits each point once. Loops do not cross: two of them that are cut from
// each other at a point have no other place where they could, and closed curves cross an even number of times.
#pragma once

#include <sunder/planar/polygons/ring_points.h>

#include <cstdint>
#include <vector>

namespace sunder::planar {

struct RingLoop {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t ring = 0;       // a position in the set's rings
  std::uint32_t cut_at = none;  // the point (of RingPoints) at which it was cut from the rest; none: it is the rest
  std::uint32_t first = none;   // the lower one of its two ways at its lexicographically first point, in RingPoints
  std::uint32_t parent = none;  // the innermost loop that it is inside of
};

struct RingLoops {
  std::vector<RingLoop> loops;         // those with a parent stand after it
  std::vector<std::uint32_t> of_ways;  // of each way of the points: its loop
};

// Requires that no two passes at a point cross. Cost: O(k log k) for k ways.
RingLoops ring_loops(const RingSet& rings, const RingPoints& points);

}  // namespace sunder::planar
