#include <sunder/polytope/pair/evidence.h>
#include <sunder/polytope/pair/placed.h>

#include <optional>
#include <utility>

namespace sunder::polytope {

namespace {

bool is_positive(const Dyadic& x) { return x.sign() == Sign::positive; }

Dyadic total(const Weights& weights) {
  Dyadic sum;
  for (const Weights::Part& part : weights.parts) sum = sum + part.numerator;
  return sum;
}

// An upper bound of the products of the body with a direction; nothing where none is proved.
std::optional<ExactFraction> bound_along(const Polytope& body, const Pose& pose, const ExactVector& direction,
                                         const Weights& multipliers) {
  const auto row = [&](std::uint32_t k) { return body.row(k); };
  if (!body.is_of_points()) return bound_along(pose, direction, multipliers, row, body.size());
  if (!multipliers.parts.empty()) return std::nullopt;
  const ExactVector wanted = pulled(pose, direction);
  std::optional<Dyadic> greatest;
  for (std::uint32_t k = 0; k < body.size(); ++k) {
    Dyadic product = dot(wanted, body.row(k));
    if (!greatest || is_positive(product - *greatest)) greatest = std::move(product);
  }
  return ExactFraction{*greatest + dot(direction, pose.translation())};
}

// Does the body hold the point, by its weights or at its place?
bool holds(const Polytope& body, const Pose& pose, const ExactEvidence& evidence, const Weights& weights,
           const ExactPointN& place) {
  const std::size_t d = body.dimension();
  const bool is_of_points = body.is_of_points();
  if (is_of_points ? !place.numbers.empty() : !weights.parts.empty()) return false;
  const auto sum = weighted_sum(weights, [&](std::uint32_t k) { return body.row(k); }, body.size(), d);
  if (!sum) return false;
  const Dyadic& w = is_of_points ? weights.denominator : place.denominator;
  const ExactVector& v = is_of_points ? *sum : place.numbers;
  if (v.size() != d || !is_positive(w)) return false;
  if (is_of_points) {
    if (!(total(weights) == w)) return false;
  } else {
    for (std::uint32_t k = 0; k < body.size(); ++k) {
      const std::span<const double> row = body.row(k);
      if (is_positive(dot(v, row.first(d)) - w * Dyadic(row[d]))) return false;
    }
  }
  const ExactVector image = turned(pose, v);
  for (std::size_t r = 0; r < d; ++r) {
    const Dyadic moved = image[r] + w * Dyadic(pose.translation()[r]);
    if (!(moved * evidence.denominator == evidence.numbers[r] * w)) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const ExactEvidence> exact_part(const Evidence& evidence) {
  if (const auto* apart = std::get_if<ExactParting>(&evidence)) return apart->exact;
  const auto* meet = std::get_if<ExactMeeting>(&evidence);
  return meet != nullptr ? meet->exact : nullptr;
}

Evidence evidence_of(Verdict verdict, std::shared_ptr<const ExactEvidence> exact) {
  if (verdict == Verdict::apart) return ExactParting{std::move(exact)};
  return ExactMeeting{std::move(exact)};
}

bool check(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b, Verdict verdict,
           const ExactEvidence& evidence) {
  if (evidence.numbers.size() != a.dimension() || !is_positive(evidence.denominator)) return false;
  if (verdict == Verdict::meet) {
    return holds(a, pose_a, evidence, evidence.of_a, evidence.in_a) &&
           holds(b, pose_b, evidence, evidence.of_b, evidence.in_b);
  }
  const auto of_a = bound_along(a, pose_a, evidence.numbers, evidence.of_a);
  const auto of_b = bound_along(b, pose_b, negated(evidence.numbers), evidence.of_b);
  // greatest of A < least of B = -(greatest of B along the opposite)
  return of_a && of_b && *of_a < ExactFraction{-of_b->numerator, of_b->denominator};
}

}  // namespace sunder::polytope
