#include <sunder/predicate/point/shortest_way.h>

namespace sunder {

std::optional<ExactWay> exact_way(std::span<const Posed3> a, std::span<const Posed3> b) {
  const FlatArrows<Dyadic> arrows = flat_arrows<Dyadic>(a, b);
  ExactWay found{shortest_way(arrows), {}};
  ShortestWay<Dyadic>& way = found.way;
  const Sign side = way.reach.sign();
  if (side == Sign::zero) return std::nullopt;
  found.weight = weights_of(arrows, way);
  for (const Dyadic& weight : found.weight) {
    if (weight.sign() == Sign::negative) return std::nullopt;
  }
  if (side == Sign::negative) {
    way.way = {-way.way.x, -way.way.y, -way.way.z};
    way.reach = -way.reach;
  }
  return found;
}

EnclosedWay enclosed_way(std::span<const Posed3> a, std::span<const Posed3> b) {
  const FlatArrows<Interval> arrows = flat_arrows<Interval>(a, b);
  const ShortestWay<Interval> found = shortest_way(arrows);
  const std::array<Interval, 4> weights = weights_of(arrows, found);
  bool is_sure = true;
  for (std::size_t k = 0; k < a.size() + b.size(); ++k) {
    const Guess weight = sign(weights[k]);
    if (weight == Guess::negative) return {Guess::negative, {}};
    is_sure &= weight == Guess::positive;
  }
  // The reach of less than two edges is never negative: so it is positive where no weight and no way is zero.
  const Guess side = found.edges == 2 ? sign(found.reach) : Guess::positive;
  const auto& [x, y, z] = found.way;
  if (!is_sure || side == Guess::unsure || side == Guess::zero) return {};
  return {Guess::positive, side == Guess::positive ? found.way : Vector3<Interval>{-x, -y, -z}};
}

EnclosedAlong::EnclosedAlong(const Vector3<Interval>& direction, const Affine3& pose) {
  const auto column = [&](std::size_t j) {
    const auto& m = pose.linear;
    return Interval(m[j]) * direction.x + Interval(m[3 + j]) * direction.y + Interval(m[6 + j]) * direction.z;
  };
  pulled_ = {column(0), column(1), column(2)};
}

}  // namespace sunder
