#include <sunder/base/contract.h>
#include <sunder/solid/hull/affine_basis.h>

#include <sunder/predicate/point/orient.h>

#include <cmath>
#include <tuple>

namespace sunder::solid {

namespace {

bool lexicographically_less(const Point3& p, const Point3& q) {
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

Point3 cross(const Point3& u, const Point3& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
double dot(const Point3& u, const Point3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Point3 difference(const Point3& p, const Point3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }

// The first point with the greatest distance (a guess in floating point) if it is accepted, else the first accepted
// one, if any.
template <class Distance, class Accept>
std::optional<std::uint32_t> farthest_accepted(std::span<const Point3> points, const Distance& distance,
                                               const Accept& accept) {
  std::uint32_t farthest = 0;
  double greatest = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double d = distance(points[i]);
    if (d > greatest) {
      greatest = d;
      farthest = i;
    }
  }
  if (accept(points[farthest])) return farthest;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (accept(points[i])) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> projection_axis(const Point3& a, const Point3& b, const Point3& c) {
  for (const int axis : {0, 1, 2}) {
    if (orient_2d_along(axis, a, b, c) != Sign::zero) return axis;
  }
  return std::nullopt;
}

std::vector<std::uint32_t> affine_basis(std::span<const Point3> points) {
  SUNDER_REQUIRE(!points.empty());
  std::uint32_t lowest = 0, highest = 0;
  for (std::uint32_t i = 1; i < points.size(); ++i) {
    if (lexicographically_less(points[i], points[lowest])) lowest = i;
    if (lexicographically_less(points[highest], points[i])) highest = i;
  }
  const Point3& a = points[lowest];
  const Point3& b = points[highest];
  if (a == b) return {lowest};

  const Point3 ab = difference(b, a);
  const auto third = farthest_accepted(
      points,
      [&](const Point3& p) {
        const Point3 area = cross(ab, difference(p, a));
        return dot(area, area);
      },
      [&](const Point3& p) { return projection_axis(a, b, p).has_value(); });
  if (!third) return {lowest, highest};

  const Point3& c = points[*third];
  const Point3 normal = cross(ab, difference(c, a));
  const auto fourth = farthest_accepted(
      points, [&](const Point3& p) { return std::abs(dot(normal, difference(p, a))); },
      [&](const Point3& p) { return orient_3d(a, b, c, p) != Sign::zero; });
  if (!fourth) return {lowest, highest, *third};
  return {lowest, highest, *third, *fourth};
}

}  // namespace sunder::solid
