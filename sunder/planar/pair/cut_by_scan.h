// The oracle of polygon_line, polygon_ray and polygon_segment: it shares no search with them.
#pragma once

#include <sunder/planar/pair/polygon_cut.h>

namespace sunder::planar {

// Looks at every vertex and every edge; where the line begins or ends is compared in exact fractions. Requires two
// different points, but for a segment.
PolygonCut cut_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b, OwnEnds ends);

}  // namespace sunder::planar
