// The exact image of a vertex of a placed convex polygon.
#pragma once

#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/pose.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/line/crossing.h>

#include <cstdint>

namespace sunder::planar {

inline Vector2<Dyadic> image(const ConvexPolygon& polygon, const Pose& pose, std::uint32_t v) {
  return coordinates<Dyadic>(Posed2{polygon[v], &pose.affine(), false});
}
inline ExactPoint2 exact_vertex(const ConvexPolygon& polygon, const Pose& pose, std::uint32_t v) {
  const Vector2<Dyadic> p = image(polygon, pose, v);
  return {p.x, p.y, 1.0};
}

}  // namespace sunder::planar
