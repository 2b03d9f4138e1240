#include <sunder/certificate/common_point.h>
#include <sunder/predicate/coordinates.h>

#include <algorithm>

namespace sunder {

void Weights::add(std::uint32_t index, const Dyadic& numerator) {
  const auto same = std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.index == index; });
  if (same == parts.end()) {
    parts.push_back({index, numerator});
  } else {
    same->numerator = same->numerator + numerator;
  }
}

std::array<Dyadic, 3> way_between(const PointOf& from, const PointOf& to) {
  std::array<Dyadic, 3> way;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    way[axis] = to.at[axis] * from.at.denominator - from.at[axis] * to.at.denominator;
  }
  return way;
}

CommonPoint common_point(const CommonVertices& evidence, std::span<const Posed3> vertices) {
  const std::size_t of_a = evidence.count_a;
  const std::array<Dyadic, 5> weights = common_point_weights(vertices.first(of_a), vertices.subspan(of_a));
  CommonPoint point;
  point.at.denominator = Dyadic(0.0);
  Vector3<Dyadic> sum{};
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    (k < of_a ? point.of_a : point.of_b).parts.push_back({evidence.vertices[k], weights[k]});
    if (k >= of_a) continue;
    const Vector3<Dyadic> p = coordinates<Dyadic>(vertices[k]);
    sum = {sum.x + weights[k] * p.x, sum.y + weights[k] * p.y, sum.z + weights[k] * p.z};
    point.at.denominator = point.at.denominator + weights[k];
  }
  point.at = exact_point(sum, point.at.denominator);
  point.of_a.denominator = point.of_b.denominator = point.at.denominator;
  return point;
}

}  // namespace sunder
