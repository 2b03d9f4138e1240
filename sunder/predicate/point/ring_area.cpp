#include <sunder/number/dyadic.h>
#include <sunder/predicate/point/ring_area.h>

#include <cstddef>

namespace sunder {

Sign ring_area_along(int axis, std::span<const Point3> points, std::span<const std::uint32_t> ring) {
  const std::size_t u = (static_cast<std::size_t>(axis) + 1) % 3, v = (u + 1) % 3;
  Dyadic sum;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point3 &p = points[ring[k]], &q = points[ring[k + 1 < ring.size() ? k + 1 : 0]];
    sum = sum + Dyadic(p[u]) * Dyadic(q[v]) - Dyadic(p[v]) * Dyadic(q[u]);
  }
  return sum.sign();
}

}  // namespace sunder
