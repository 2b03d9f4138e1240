#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/object/flatness.h>

#include <cmath>
#include <optional>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

Exact exact_cross(const Point3& a, const Point3& b, const Point3& c) {
  const Exact from = coordinates<Dyadic>(a);
  return cross(coordinates<Dyadic>(b) - from, coordinates<Dyadic>(c) - from);
}

// The point with the greatest measure; a measure that overflows is greatest.
template <class Measure>
std::uint32_t greatest(std::uint32_t count, const Measure& measure) {
  std::uint32_t best = 0;
  double most = -1;
  for (std::uint32_t k = 0; k < count; ++k) {
    const double size = measure(k);
    if (size > most || std::isnan(size)) {
      most = std::isnan(size) ? HUGE_VAL : size;
      best = k;
    }
  }
  return best;
}

double span_of(const Point3& a, const Point3& b) {
  return std::fabs(a.x - b.x) + std::fabs(a.y - b.y) + std::fabs(a.z - b.z);
}

// Three points that are not on one line, chosen by floating point; where that chooses badly, the first that there are.
std::optional<std::array<std::uint32_t, 3>> base(std::span<const Point3> p) {
  const auto n = static_cast<std::uint32_t>(p.size());
  const std::uint32_t far = greatest(n, [&](std::uint32_t k) { return span_of(p[0], p[k]); });
  const std::uint32_t wide = greatest(n, [&](std::uint32_t k) {
    const Point3 u{p[far].x - p[0].x, p[far].y - p[0].y, p[far].z - p[0].z};
    const Point3 v{p[k].x - p[0].x, p[k].y - p[0].y, p[k].z - p[0].z};
    return std::fabs(u.y * v.z - u.z * v.y) + std::fabs(u.z * v.x - u.x * v.z) + std::fabs(u.x * v.y - u.y * v.x);
  });
  if (!are_collinear(p[0], p[far], p[wide])) return std::array{0u, far, wide};
  std::uint32_t other = 0;
  for (std::uint32_t k = 1; k < n; ++k) {
    if (p[other] == p[0]) other = k;
    if (!are_collinear(p[0], p[other], p[k])) return std::array{0u, other, k};
  }
  return std::nullopt;
}

// About p / sqrt(q), of positive numbers of any size.
double ratio_to_root(const Dyadic& p, const Dyadic& q) {
  const std::int64_t half = q.top() / 2;
  const double ratio = p.scaled(-p.top()).nearest() / std::sqrt(q.scaled(-2 * half).nearest());
  return std::ldexp(ratio, static_cast<int>(p.top() - half));
}

}  // namespace

Flatness flatness(std::span<const Point3> points) {
  Flatness result;
  if (points.size() < 4) return result;
  const auto three = base(points);
  if (!three) return result;
  const auto [i, j, k] = *three;
  const Point3 &a = points[i], &b = points[j], &c = points[k];
  Dyadic most;
  const Exact normal = exact_cross(a, b, c), from = coordinates<Dyadic>(a);
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (orient_3d(a, b, c, points[v]) == Sign::zero) continue;
    Dyadic height = dot(normal, coordinates<Dyadic>(points[v]) - from);
    if (height.sign() == Sign::negative) height = -height;
    if (!result.is_flat && (height - most).sign() != Sign::positive) continue;
    result = {false, v, *three, 0};
    most = height;
  }
  if (!result.is_flat) result.distance = ratio_to_root(most, dot(normal, normal));
  return result;
}

}  // namespace sunder::solid
