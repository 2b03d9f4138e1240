#include <sunder/polytope/pair/half_space_weights.h>

#include <memory>
#include <utility>

namespace sunder::polytope {

std::optional<ExactDecision> met_by_weights(Placed& half_spaces, Placed& points, std::span<const Weighted> of_points,
                                            Cost& cost) {
  if (of_points.empty()) return std::nullopt;
  ++cost.proposals;
  const std::size_t d = points.dimension();
  ExactEvidence common;
  common.numbers.resize(d);
  Dyadic total;
  for (const auto& [index, weight] : of_points) {
    if (weight.sign() == Sign::negative) return std::nullopt;
    if (weight.sign() == Sign::zero) continue;
    total = total + weight;
    const ExactVector image = points.image(index);
    for (std::size_t c = 0; c < d; ++c) common.numbers[c] = common.numbers[c] + weight * image[c];
    common.of_b.parts.push_back({index, weight});
  }
  if (total.sign() != Sign::positive || half_spaces.breaks_any(common.numbers, total, cost)) return std::nullopt;
  common.denominator = common.of_b.denominator = total;
  common.in_a = {half_spaces.unplaced(common.numbers, total), total * half_spaces.scale()};
  return ExactDecision{Verdict::meet, std::make_shared<const ExactEvidence>(std::move(common))};
}

std::optional<ExactDecision> parted_by_weights(Placed& half_spaces, Placed& points,
                                               std::span<const Weighted> of_half_spaces, Cost& cost) {
  ++cost.proposals;
  const std::size_t d = points.dimension();
  ExactEvidence parting;
  parting.numbers.resize(d);
  Dyadic side;
  for (const auto& [index, weight] : of_half_spaces) {
    const ExactVector row = half_spaces.half_space(index);
    for (std::size_t c = 0; c < d; ++c) parting.numbers[c] = parting.numbers[c] + weight * row[c];
    side = side + weight * row[d];
    parting.of_a.parts.push_back({index, weight * half_spaces.scale()});
  }
  const Dyadic least = -points.furthest(negated(parting.numbers), cost).product;
  if ((least - side).sign() != Sign::positive) return std::nullopt;
  return ExactDecision{Verdict::apart, std::make_shared<const ExactEvidence>(std::move(parting))};
}

}  // namespace sunder::polytope
