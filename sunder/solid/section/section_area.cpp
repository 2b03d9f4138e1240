#include <sunder/number/dyadic.h>
#include <sunder/number/vector.h>
#include <sunder/solid/section/section_area.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

// From one point to another, times both denominators.
Exact way_between(const ExactPoint3& p, const ExactPoint3& q) {
  return {q.x * p.denominator - p.x * q.denominator, q.y * p.denominator - p.y * q.denominator,
          q.z * p.denominator - p.z * q.denominator};
}

}  // namespace

AreaBounds section_area(const PlaneSection& section, const SectionPoints& points, const Point3& normal) {
  if (section.kind != SectionKind::polygon) return {};
  const double most = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
  const std::int64_t scale = -std::ilogb(most);  // times two to this, the normal has a length from 1 to 4
  const Exact up{Dyadic(normal.x).scaled(scale), Dyadic(normal.y).scaled(scale), Dyadic(normal.z).scaled(scale)};
  const double x = up.x.nearest(), y = up.y.nearest(), z = up.z.nearest();
  constexpr double least = 0x1p-1000;  // below, doubles have too few digits

  // Triangles at the first corner: each has the product of the normal with that of its ways for its area, times twice
  // the normal's length. All are positive, so relative errors of 2^-53 stay so in their sum: one of a term, and one of
  // each sum; the rest is for the length and the last products.
  const ExactPoint3 first = points.exact(section.corners[0]);
  ExactPoint3 last = points.exact(section.corners[1]);
  Exact way = way_between(first, last);
  double low = 0, high = 0;
  for (std::size_t k = 2; k < section.corners.size(); ++k) {
    const ExactPoint3 here = points.exact(section.corners[k]);
    const Exact next = way_between(first, here);
    const double twice = nearest_ratio(dot(up, cross(way, next)),
                                       first.denominator * first.denominator * last.denominator * here.denominator);
    low += twice < least ? 0 : twice;
    high += std::max(twice, least);
    last = here;
    way = next;
  }
  const double length = 2 * std::sqrt(x * x + y * y + z * z);
  const double part = static_cast<double>(section.corners.size() + 16) * 0x1p-52;
  if (!std::isfinite(high)) return {0, std::numeric_limits<double>::infinity()};
  return {low * (1 - part) / length, high * (1 + part) / length};
}

}  // namespace sunder::solid
