#include <sunder/predicate/shortest_way.h>

namespace sunder {

std::optional<ShortestWay<Dyadic>> exact_way(std::span<const Posed3> a, std::span<const Posed3> b) {
  ShortestWay<Dyadic> found = shortest_way_of<ExactStage>(a, b);
  const Sign side = found.reach.sign();
  if (side == Sign::zero) return std::nullopt;
  for (const Dyadic& weight : found.weight) {
    if (weight.sign() == Sign::negative) return std::nullopt;
  }
  if (side == Sign::negative) {
    found.way = {-found.way.x, -found.way.y, -found.way.z};
    found.reach = -found.reach;
  }
  return found;
}

EnclosedWay enclosed_way(std::span<const Posed3> a, std::span<const Posed3> b) {
  const ShortestWay<Interval> found = shortest_way_of<IntervalStage>(a, b);
  bool is_sure = true;
  for (std::size_t k = 0; k < a.size() + b.size(); ++k) {
    const Guess weight = sign(found.weight[k]);
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
