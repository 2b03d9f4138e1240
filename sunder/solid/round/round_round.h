// Do two placed bodies with a radius meet? A polyhedron is one of radius 0, so that any two bodies are one question.
// Also called: collision detection of primitives: sphere, capsule, box, cylinder, cone, ellipsoid, convex mesh.
//
// The bodies are closed: touching is meeting.
//   R1. apart and meet are exactly right for the doubles given: never is one said of a pair of the other.
//   R2. With each of them comes evidence in numbers that exact arithmetic has checked: a direction that parts them, or
//       a rational point of both.
//   R3. Decided always: two hulls, of any radii; a cylinder or an ellipsoid against a polyhedron of radius 0.
//   R4. Other pairs may be undecided. A cone against a polyhedron of radius 0 only where no direction was found that
//       parts what its features show to be apart; where one body is curved and the other curved, or of a radius above
//       0, where the gap or the depth is below some 2^-76 of their size (one in 50 there, one in 500 at 2^-72, one in
//       2,000 at 2^-60); of what is thinner than some 2^-8 of its width rarely more, at its rim: up to 2^-36 was seen.
//   R5. The answer and the evidence are the same for every compiler, thread count and vector unit.
// What one might assume and does not hold: swapped bodies may get other evidence, and of undecided ones an answer.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/common_point.h>
#include <sunder/certificate/direction.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/certificate/rounded_evidence.h>
#include <sunder/solid/round/round_body.h>

#include <array>
#include <cstdint>
#include <memory>
#include <variant>

namespace sunder::solid {

// A point as a combination of points of a body: weight over the sum of the weights, all positive.
struct RoundCombination {
  std::array<std::uint32_t, 4> vertices;  // the first count() are set
  std::array<double, 4> weights{};        // 0 behind these

  std::uint8_t count() const {
    std::uint8_t n = 0;
    while (n < weights.size() && weights[n] > 0) ++n;
    return n;
  }
};

// Apart, as along a direction from A to B.
struct SeparatingDirection {
  static constexpr Verdict verdict = Verdict::apart;
  Point3 direction{};
};

// The same along one that doubles cannot hold; `near` is near it.
struct ExactSeparatingDirection {
  static constexpr Verdict verdict = Verdict::apart;
  Point3 near{};
  std::shared_ptr<const std::array<Dyadic, 3>> exact;  // not null
};

// They meet in a point that divides the way between a point of each core as the radii are.
struct PointBetweenCores {
  static constexpr Verdict verdict = Verdict::meet;
  RoundCombination of_a, of_b;
};

// They meet in a point of doubles. Of hulls it is near the point of the core that the combination makes; the
// combination of another body is of no point.
struct PointInDoubles {
  static constexpr Verdict verdict = Verdict::meet;
  Point3 at{};
  RoundCombination of_a{}, of_b{};
};

// They meet in a point of the core of one of them, which is a hull; the other one is curved.
struct PointOfCore {
  static constexpr Verdict verdict = Verdict::meet;
  bool is_of_a = true;
  RoundCombination made;
};

// They meet because their cores do.
struct CoresMeet {
  static constexpr Verdict verdict = Verdict::meet;
  CommonVertices of_cores;
};

struct ExactCommonPoint {
  static constexpr Verdict verdict = Verdict::meet;
  std::shared_ptr<const CommonPoint> point;  // not null
};

// It is not known whether they meet: they touch, or nearly, across this direction; zero where not even that is known.
struct NearlyTouching {
  static constexpr Verdict verdict = Verdict::undecided;
  Point3 direction{};
};

// What is known of two bodies: the evidence of polyhedra where both are polyhedra, else one of the others. It names no
// body, and exact numbers are made when asked for.
using RoundEvidence =
    std::variant<NearlyTouching, Separation, CommonVertices, SeparatingDirection, ExactSeparatingDirection,
                 PointBetweenCores, PointInDoubles, PointOfCore, CoresMeet, ExactCommonPoint>;
using RoundAnswer = Answer<RoundEvidence>;

// That they are apart, as along this direction.
RoundEvidence separation_along(const WorldDirection& direction);

// The same answer, as one of bodies with a radius.
RoundAnswer round_answer(PairAnswer&& of_polyhedra);

// The front door. Searches for a direction or a point in floating point, in doubles and then in double-doubles, and
// accepts it only by exact signs (predicate/disc/round_shape.h). Where none holds: of two hulls the exact distance of their
// cores against the exact sum of the radii; of a curved body and a polyhedron of radius 0 an exact convex quadratic
// program, of a cone its features. Cost: at most 100 steps of search in each precision, each of O(log n + log m)
// probes; of the exact methods for a curved body O(n) exact numbers a step. Throws Error: bad_pose (round_body.h).
// Source of the search: Gilbert, Johnson, Keerthi 1988.
RoundAnswer round_round(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b);
RoundAnswer round_round(const PlacedRound& a, const PlacedRound& b);

// The direction, and the common point with how each body makes it: for certificate files. Require the verdict, and the
// bodies that the evidence is of.
std::array<Dyadic, 3> direction_of(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence);
CommonPoint common_point_of(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence);

// In doubles: a direction along which searches may begin, of any length.
Point3 near_direction(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence);

// For people: where the common point is, rounded; the direction, of length one up to rounding, of bodies that do not
// meet; with it, how wide the empty slab across it is, about. Require the verdict: meet; apart or undecided; apart.
Point3 rounded_point_of(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence);
Point3 rounded_direction(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence);
RoundedGap rounded_gap(const PlacedRound& a, const PlacedRound& b, const RoundEvidence& evidence);

// The point that divides the way from p to q as the radii are; of two radii of 0: p.
CommonPoint point_between(const PointOf& p, double radius_p, const PointOf& q, double radius_q);

}  // namespace sunder::solid
