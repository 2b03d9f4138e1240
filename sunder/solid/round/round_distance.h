// How far apart are two placed bodies, each with a radius or without?
// Also called: separation distance of primitives; minimum distance; proximity query.
//
//   For any two placed parts:
//     PlacedRound a(body_a, pose_a), b(body_b, pose_b);      // round_body.h; a polyhedron converts to a RoundBody
//     distance_of(round_distance(a, b))                      // low <= the distance <= high, both proved
//     is_kept(round_clearance(a, b, least))                  // round_clearance.h: at least so far apart? exact
//   Both have add_claims, which write their proofs.
//
//   D1. low <= the distance <= high, exactly: along a direction they are `low` apart, and two points, one of each, are
//       nearer than the next double above `high`.
//   D2. Of two hulls of any radii they are both ends where a double is the distance, else one unit in the last place is
//       between them.
//   D3. Of curved bodies they are some units in the last place apart, but not always: the distance of curved bodies is
//       a root of a polynomial of high degree, and is searched for, in double-doubles. high - low <= 2^-40 of the size
//       of the pair is what tests demand.
//   D4. {0, 0} is said only of what meets, and always where round_round says so. Where that is undecided low is 0.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/number/interval.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_round.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>

namespace sunder::solid {

// They are apart, and hulls of which one has a radius: their cores are nearest at these features, and further apart than the radii together.
struct HullsApart {
  static constexpr Verdict verdict = Verdict::apart;
  ClosestFeatures cores;
  double radius_a = 0, radius_b = 0;

  // Made when asked for, in exact numbers.
  Interval distance() const;
  std::array<PointOf, 2> points() const;  // of A and of B, as D1 says
  WorldDirection direction() const;       // from A to B, along which they are so far apart
};

// They are apart, and one is curved.
struct CurvedApart {
  struct Nearest {
    WorldDirection direction;       // from A to B, along which they are distance.low apart
    std::array<PointOf, 2> points;  // of A and of B, as D1 says
  };

  static constexpr Verdict verdict = Verdict::apart;
  Interval distance;
  std::shared_ptr<const Nearest> nearest;  // not null
};

// It is not known whether they meet; they are no further apart than that.
struct PerhapsApart {
  static constexpr Verdict verdict = Verdict::undecided;
  double at_most = 0;
  std::shared_ptr<const std::array<PointOf, 2>> points;  // as D1 says; not null
};

// Of two polyhedra CommonVertices, or their closest features.
using RoundDistanceEvidence =
    std::variant<PerhapsApart, CommonVertices, ClosestFeatures, ExactCommonPoint, HullsApart, CurvedApart>;
using RoundDistance = Answer<RoundDistanceEvidence>;

// Beyond the range of doubles: the largest, and infinity.
Interval distance_of(const RoundDistanceEvidence& evidence);
inline Interval distance_of(const RoundDistance& answer) { return distance_of(answer.evidence); }

// Is the first distance less than the second? Exact. Nothing, unless both are of hulls that are apart.
std::optional<bool> is_nearer(const RoundDistanceEvidence& one, const RoundDistanceEvidence& other);

// The nearest points of A and of B, rounded (of curved ones, about so near as `high`); where they meet, nothing.
std::optional<std::array<Point3, 2>> rounded_nearest(const RoundDistanceEvidence& evidence);

// Points of A and of B as D1 says. Requires the bodies that the evidence is of.
std::array<PointOf, 2> nearest_of(const PlacedRound& a, const PlacedRound& b, const RoundDistanceEvidence& evidence);

// Asks first whether they meet. Throws Error: bad_pose. Cost: that of round_round, and again at most 100 steps of
// search in each precision, and some hundred exact numbers; of two hulls that of polyhedron_polyhedron_distance, and of
// two polyhedra nothing else.
RoundDistance round_distance(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b);
RoundDistance round_distance(const PlacedRound& a, const PlacedRound& b);

// States it of two bodies of a certificate file, as two clearances: kept is `low`; broken is `high` where the points
// are nearer than that, else the next double. One of them is left out where low is 0, or high is not finite.
void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const RoundDistance& distance);

// States how far apart two polyhedra are, exactly; of others, that they are nearer than the next double above `high`,
// where that is finite. Of bodies that meet nothing: that they do is stated elsewhere.
void add_distance(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const RoundDistanceEvidence& found);

}  // namespace sunder::solid
