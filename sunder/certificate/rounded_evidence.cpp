#include <sunder/certificate/common_point.h>
#include <sunder/certificate/rounded_evidence.h>
#include <sunder/predicate/coordinates.h>

#include <cmath>

namespace sunder {

Point3 rounded_common_point(const CommonVertices& c, const PlacedVertices& a, const PlacedVertices& b) {
  return nearest(common_point(c, a, b).at);
}

RoundedGap rounded_gap(const Separation& c, const PlacedVertices& a, const PlacedVertices& b) {
  const Vector3<Dyadic> d = world_direction(c.direction, a, b).exact();
  Dyadic longest;  // the largest magnitude of an entry
  for (const Dyadic* entry : {&d.x, &d.y, &d.z}) {
    const Dyadic size = entry->sign() == Sign::negative ? -*entry : *entry;
    if ((size - longest).sign() == Sign::positive) longest = size;
  }
  const Point3 near{nearest_ratio(d.x, longest), nearest_ratio(d.y, longest), nearest_ratio(d.z, longest)};
  const double length = std::sqrt(near.x * near.x + near.y * near.y + near.z * near.z);
  const Vector3<Dyadic> between = coordinates<Dyadic>(b[c.extreme_b]) - coordinates<Dyadic>(a[c.extreme_a]);
  return {{near.x / length, near.y / length, near.z / length},
          nearest_ratio(dot(d, between), longest * Dyadic(length))};
}

}  // namespace sunder
