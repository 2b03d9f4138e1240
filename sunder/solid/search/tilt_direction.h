// The last step of a search that ends apart. Nothing here decides anything.
#pragma once

#include <sunder/predicate/point/along.h>
#include <sunder/solid/search/closest_simplex.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sunder::solid {

// The direction as a certificate can hold it: tame, and with one vertex of the difference clearly furthest.
//
// Near contact the direction is perpendicular to a face of the difference, whose vertices then tie. So it is turned a
// little towards one of them, at the cost of at most a quarter of the gap, and floating point can tell the extreme
// vertices. `w` is what the direction found; it becomes the vertex that is now furthest. Returns false for a direction
// that is zero or not finite.
inline bool tilt_direction(const DifferenceSimplex& simplex, Point3& d, DifferenceVertex& w) {
  if (!make_tame(d)) return false;
  const std::size_t n = static_cast<std::size_t>(simplex.count);
  if (n < 2) return true;
  Point3 centroid;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3& p = simplex.vertex[i].at;
    centroid = {centroid.x + p.x, centroid.y + p.y, centroid.z + p.z};
  }
  const double part = 1.0 / simplex.count;
  centroid = {centroid.x * part, centroid.y * part, centroid.z * part};
  const auto from_centroid = [&](const Point3& p) {
    return Point3{p.x - centroid.x, p.y - centroid.y, p.z - centroid.z};
  };
  // A vertex clearly beyond the face is furthest anyway.
  const double gap = -dot(d, w.at);
  const Point3 beyond = from_centroid(w.at);
  const double height = dot(d, beyond);
  if (height * height > 0x1p-40 * dot(beyond, beyond)) return true;
  // Else the vertex of the face that is furthest from the centroid.
  Point3 e;
  double length2 = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 f = from_centroid(simplex.vertex[i].at);
    if (dot(f, f) <= length2) continue;
    length2 = dot(f, f);
    e = f;
    w = simplex.vertex[i];
  }
  const double amount = std::min(0x1p-7 / std::sqrt(length2), 0.25 * gap / std::fabs(dot(e, w.at)));
  d = {d.x + amount * e.x, d.y + amount * e.y, d.z + amount * e.z};
  return make_tame(d);
}

}  // namespace sunder::solid
