// Bodies of given corners, and their vertices.
#pragma once

#include <sunder/solid/object/convex_polyhedron.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sunder::solid {

inline ConvexPolyhedron body(const std::vector<Point3>& points) { return ConvexPolyhedron(points); }

inline ConvexPolyhedron box(const Point3& low, const Point3& high) {
  std::vector<Point3> points;
  for (const double x : {low.x, high.x}) {
    for (const double y : {low.y, high.y}) {
      for (const double z : {low.z, high.z}) points.push_back({x, y, z});
    }
  }
  return ConvexPolyhedron(points);
}

inline const ConvexPolyhedron two_cube = box({0, 0, 0}, {2, 2, 2});

inline std::uint32_t vertex_at(const ConvexPolyhedron& body, const Point3& p) {
  const auto vertices = body.vertices();
  return static_cast<std::uint32_t>(std::find(vertices.begin(), vertices.end(), p) - vertices.begin());
}

}  // namespace sunder::solid
