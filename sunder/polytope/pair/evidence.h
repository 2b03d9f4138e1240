// The answer to "do these two polytopes meet?", with its evidence, in any dimension.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/certificate/common_point.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/number/dyadic.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/object/pose.h>

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace sunder::polytope {

// What proves an answer about A and B, in exact numbers. `x` is `numbers` over the denominator, which is positive.
struct ExactEvidence {
  // apart: a direction d (no denominator). No point of A is as far along it as any of B:
  //   of points, the greatest product of d is at a row; of half-spaces, with non-negative multipliers m whose combined
  //   normals are linear^T d (for B: -linear^T d), it is at most the combined b, and d . translation.
  // So two products with d are strictly apart. d may be zero: then half-spaces alone contradict.
  // meet: a common point x in the world.
  std::vector<Dyadic> numbers{};
  Dyadic denominator{1.0};
  // meet, points: weights of rows that sum to 1. apart, half-spaces: multipliers. Else empty. Two bodies of points name
  // d + 2 points at most, in total; half-spaces with multipliers are d + 1 at most, in total, where both are of
  // half-spaces.
  Weights of_a{}, of_b{};
  // meet, half-spaces: the point in the frame of the body, over its own denominator. Else empty.
  ExactPointN in_a{}, in_b{};
};

// Two bodies of points are apart, as along this direction of doubles.
struct PartingDirection {
  static constexpr Verdict verdict = Verdict::apart;
  std::array<double, most_dimension> direction{};
};

// Two bodies of points meet: the hulls of these points of A and of B have a common one.
struct CommonPoints {
  static constexpr Verdict verdict = Verdict::meet;
  std::uint8_t count_a = 0, count_b = 0;
  std::array<std::uint32_t, most_dimension + 1> of_a{}, of_b{};
};

// What exact methods found: always where a body is of half-spaces. Not null.
struct ExactParting {
  static constexpr Verdict verdict = Verdict::apart;
  std::shared_ptr<const ExactEvidence> exact;
};
struct ExactMeeting {
  static constexpr Verdict verdict = Verdict::meet;
  std::shared_ptr<const ExactEvidence> exact;
};

// As the search leaves it.
using Evidence = std::variant<PartingDirection, CommonPoints, ExactParting, ExactMeeting>;
using PolytopeAnswer = Answer<Evidence>;  // probes: rows looked at

// What exact methods found; null where doubles were enough.
std::shared_ptr<const ExactEvidence> exact_part(const Evidence& evidence);

// Requires it not to be undecided.
Evidence evidence_of(Verdict verdict, std::shared_ptr<const ExactEvidence> exact);

// The evidence in exact numbers. Requires the answer to be about these. Cost: exact arithmetic; some small determinants
// where the evidence is of points that meet.
ExactEvidence exact_evidence(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b,
                             const PolytopeAnswer& answer);

// Does it prove the verdict? By the exact numbers alone; nothing of a search is used. Cost: linear, exact arithmetic.
bool check(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b, Verdict verdict,
           const ExactEvidence& evidence);

}  // namespace sunder::polytope
