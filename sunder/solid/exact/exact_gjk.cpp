#include <sunder/solid/exact/exact_gjk.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace sunder::solid {

namespace {

// Only these vertices. False where one that is left out is further along the direction than the first of them.
bool keep(VertexSet<Dyadic>& set, std::span<const std::uint32_t> vertices, const Vector3<Dyadic>& along) {
  VertexSet<Dyadic> kept, left;
  for (std::size_t k = 0; k < set.count; ++k) {
    const bool stays = std::find(vertices.begin(), vertices.end(), set.vertex[k]) != vertices.end();
    (stays ? kept : left).add(set.vertex[k], set.at[k]);
  }
  set = kept;
  return std::none_of(left.at.begin(), left.at.begin() + static_cast<std::ptrdiff_t>(left.count),
                      [&](const auto& at) { return dot(along, at - set.at[0]).sign() == Sign::positive; });
}

}  // namespace

ExactNearest ExactNearest::to_origin() {
  ExactNearest nearest;
  nearest.a.add(0, {});
  return nearest;
}

bool ExactNearest::reduce(std::uint32_t& ways) {
  closest = *closest_way(a, b, ways);
  ShortestWay<Dyadic>& way = closest.way;
  Vector3<Dyadic> back{-way.way.x, -way.way.y, -way.way.z};
  if (way.reach.sign() == Sign::negative) {
    std::swap(way.way, back);
    way.reach = -way.reach;
  }
  const FeatureVertices& features = closest.features;
  const std::span<const std::uint32_t> all(features.vertices);
  const bool ends_a = keep(a, all.first(features.count_a), way.way);
  const bool ends_b = keep(b, all.subspan(features.count_a, features.count_b), back);
  return ends_a && ends_b && way.reach.sign() == Sign::positive;
}

}  // namespace sunder::solid
