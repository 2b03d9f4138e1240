// A convex polygon out of vertices in either direction, as files list them: an exterior of a Shapefile is clockwise.
#pragma once

#include <sunder/base/error.h>
#include <sunder/planar/object/convex_polygon.h>

#include <vector>

namespace sunder::planar {

struct EitherWay {
  ConvexPolygon polygon;
  bool reversed = false;  // they run clockwise; then vertex k of the polygon is the (n - 1 - k)th of those given
};

// As ConvexPolygon::from_vertices, but vertices that run clockwise are taken in reverse. Which way they run is decided
// by most of their turns. Throws Error as it does; a vertex is named by its number among those given. Cost: linear.
EitherWay convex_either_way(std::vector<Point2> vertices);

}  // namespace sunder::planar
