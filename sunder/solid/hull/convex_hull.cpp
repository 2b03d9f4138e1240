#include <sunder/solid/hull/convex_hull.h>

#include <sunder/base/error.h>
#include <sunder/number/rounded.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/hull/affine_basis.h>
#include <sunder/solid/hull/canonical_order.h>
#include <sunder/solid/hull/flat_hull.h>
#include <sunder/solid/hull/merge_coplanar.h>
#include <sunder/solid/hull/quickhull.h>
#include <sunder/solid/hull/spatial_order.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace sunder::solid {

namespace {

void check(std::span<const Point3> points) {
  if (points.empty()) throw Error(ErrorCode::bad_shape, "no points: give at least one");
  if (points.size() >= std::size_t{1} << 29) throw Error(ErrorCode::bad_shape, "too many points: give fewer than 2^29");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw Error(ErrorCode::bad_value, "a coordinate is not finite: give finite numbers",
                  "point " + std::to_string(i));
    }
  }
}

// An axis along which points are so large or so small that floating point cannot filter is multiplied by a power of
// two, which changes no sign, unless a coordinate would lose bits. So this is about speed only.
void rescale(std::vector<Point3>& points, double Point3::* axis) {
  SizeRange sizes;
  for (const Point3& p : points) sizes.include(p.*axis);
  if (tame(sizes.greatest)) return;
  const int shift = -std::ilogb(sizes.greatest);
  const auto keeps_bits = [&](const Point3& p) { return std::ldexp(std::ldexp(p.*axis, shift), -shift) == p.*axis; };
  if (!std::all_of(points.begin(), points.end(), keeps_bits)) return;
  for (Point3& p : points) p.*axis = std::ldexp(p.*axis, shift);
}

ConvexHull hull_of(std::span<const Point3> points) {
  const std::vector<std::uint32_t> basis = affine_basis(points);
  switch (basis.size()) {
    case 1: return point_hull(basis[0]);
    case 2: return segment_hull(basis[0], basis[1]);
    case 3: return polygon_hull(points, *projection_axis(points[basis[0]], points[basis[1]], points[basis[2]]));
    default: break;
  }
  const Triangulation made = quickhull(points, {basis[0], basis[1], basis[2], basis[3]});
  ConvexHull hull = merge_coplanar(points, made.triangles);
  hull.side_tests = made.side_tests;
  return hull;
}

}  // namespace

ConvexHull convex_hull(std::span<const Point3> points) {
  check(points);
  const std::vector<std::uint32_t> order = spatial_order(points);
  std::vector<Point3> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t i : order) ordered.push_back(points[i]);
  for (const auto axis : {&Point3::x, &Point3::y, &Point3::z}) rescale(ordered, axis);
  ConvexHull hull = hull_of(ordered);
  for (std::uint32_t& v : hull.vertices) v = order[v];
  return in_canonical_order(hull, points.size());
}

}  // namespace sunder::solid
