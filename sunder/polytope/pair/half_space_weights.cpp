#include <sunder/polytope/pair/half_space_weights.h>

#include <utility>

namespace sunder::polytope {

std::optional<ExactDecision> met_by_weights(Placed& half_spaces, Placed& points,
                                            std::span<const Weights::Part> of_points, Cost& cost) {
  if (of_points.empty()) return std::nullopt;
  ++cost.proposals;
  ExactEvidence common{.numbers = ExactVector(points.dimension())};
  Dyadic total;
  for (const auto& [index, weight] : of_points) {
    if (weight.sign() == Sign::negative) return std::nullopt;
    if (weight.sign() == Sign::zero) continue;
    total = total + weight;
    add_multiple(common.numbers, weight, points.image(index));
    common.of_b.parts.push_back({index, weight});
  }
  if (total.sign() != Sign::positive || half_spaces.breaks_any(common.numbers, total, cost)) return std::nullopt;
  common.denominator = common.of_b.denominator = total;
  common.in_a = half_spaces.in_frame(common.numbers, total);
  return proved(Verdict::meet, std::move(common));
}

std::optional<ExactDecision> parted_by_weights(Placed& half_spaces, Placed& points,
                                               std::span<const Weights::Part> of_half_spaces, Cost& cost) {
  ++cost.proposals;
  const std::size_t d = points.dimension();
  ExactEvidence parting{.numbers = ExactVector(d)};
  Dyadic side;
  for (const auto& [index, weight] : of_half_spaces) {
    const ExactVector row = half_spaces.half_space(index);
    add_multiple(parting.numbers, weight, row);
    side = side + weight * row[d];
    parting.of_a.parts.push_back({index, weight * half_spaces.scale()});
  }
  const Dyadic least = -points.furthest(negated(parting.numbers), cost).product;
  if ((least - side).sign() != Sign::positive) return std::nullopt;
  return proved(Verdict::apart, std::move(parting));
}

}  // namespace sunder::polytope
