// What have two planes in common: nothing, a line, or all? In constant time.
// Also called: plane-plane intersection; parallel planes.
//
// As line_line.h says.
// Source: CD87, Figure 1.
#pragma once

#include <sunder/solid/line/line_line.h>
#include <sunder/solid/object/plane.h>

namespace sunder::solid {

// Exact. Cost: at most 13 signs.
FlatCommon plane_plane(const Plane& a, const Plane& b);

}  // namespace sunder::solid
