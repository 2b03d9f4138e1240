// Points that show that two polygons meet.
#pragma once

#include <sunder/planar/polygons/polygons_any.h>
#include <sunder/predicate/line/crossing.h>

namespace sunder::planar {

// Of two that overlap, a point inside of both, on no edge. Of two that touch, a common point of the edges named: of an
// overlap of edges the middle, so not a vertex in which both end. Requires polygons as polygons_any.h does, and what
// was found about them by any method but the scan: a is polygon i of it, and b is j. Cost: linear, for each edge that
// holds the place where they overlap.
ExactPoint2 common_point(const Polygon& a, const Polygon& b, const PolygonsContact& found);

// The common point that was found of two polygons that meet: the vertex inside the other one, or a common point of the
// edges named. Requires what the function above requires.
ExactPoint2 found_point(const Polygon& a, const Polygon& b, const PolygonsContact& found);

}  // namespace sunder::planar
