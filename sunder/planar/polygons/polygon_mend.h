// What may be mended of a polygon without changing what it is, but for lines without area.
// Also called: repair, cleaning; a careful part of make valid, ST_MakeValid.
#pragma once

#include <sunder/planar/polygons/polygon_valid.h>

#include <cstdint>
#include <vector>

namespace sunder::planar {

struct MendedRings {
  std::uint64_t closed = 0;    // rings that did not end where they began
  std::uint64_t spikes = 0;    // vertices at which a ring turned back on itself, cut off
  std::uint64_t repeated = 0;  // vertices that repeated the one before
  std::uint64_t left_out = 0;  // rings with fewer than three corners after that; with its shell, the polygon's holes

  std::uint64_t all() const { return closed + spikes + repeated + left_out; }
  MendedRings& operator+=(const MendedRings& other);
};

// Mends the rings, in place: afterwards each has three corners at least, ends with its first vertex, repeats no vertex
// that it just had, and nowhere turns back on itself. What else is wrong (edges that cross) stays. No rings are left
// where the shell has no area. A turn back is found exactly. Cost: linear.
MendedRings mend(PolygonRings& rings);

// Leaves out vertices that repeat the one before, all around; nothing else is changed.
void leave_out_repeated(std::vector<Point2>& ring);

}  // namespace sunder::planar
