// How deep are two placed bodies in each other, each with a radius or without?
// Also called: penetration depth of primitives.
//
// The depth is that of polyhedron_polyhedron_depth.h: the least length of a translation of A after which the two do not
// overlap.
//   P1. low <= the depth <= high, exactly, and both are proved: along `direction` A reaches by no more than `high`
//       beyond where B begins; and by `surface`, or by `points`.
//   P2. Of two hulls of any radii they are both ends where a double is the depth, else neighbouring doubles, where the
//       depth of their cores is exact.
//   P3. Of curved bodies high - low is mostly at most `width` times the depth, or 2^-40 of the size of the pair. It is
//       more, up to some 5e-3 of the depth, where the difference ends as soon along very many directions: of an
//       ellipsoid that is nearly a ball, or a cylinder or a cone about the other body, and one centre or axis. low is
//       0 where the bodies hardly meet, and where the difference is flat, or as thin as 2^-40 of its size.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/certificate/depth_claims.h>
#include <sunder/number/interval.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_round.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace sunder::solid {

struct [[nodiscard]] RoundDepth {
  static constexpr double width = 0x1p-22;
  static constexpr std::uint32_t most_corners = 1000;

  Verdict verdict = Verdict::undecided;  // unless it is meet, the rest is meaningless
  Interval depth{};
  std::optional<WorldDirection> direction{};  // from A to B
  // low > 0, one of the two: a surface around the origin, of differences of points of the cores; points of the cores
  // that are no further apart than the radii exceed `low`.
  std::shared_ptr<const DepthSurface> surface{};
  std::shared_ptr<const DepthPoints> points{};
  Cost cost;

  bool meet() const { return verdict == Verdict::meet; }
};

// Asks first whether they meet. Throws Error: bad_pose. Cost: that of round_round; of two hulls that of
// polyhedron_polyhedron_depth and polyhedron_polyhedron_distance; of others a step of search and some exact numbers a
// corner, of which there are mostly some hundred, and at most most_corners.
RoundDepth round_depth(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b);
RoundDepth round_depth(const PlacedRound& a, const PlacedRound& b);

// States it of two bodies of a certificate file (depth_claims.h), of those that meet: that it is at most `high`, and at
// least `low`. One of them is left out where low is 0, or high is not finite.
void add_depth(ClaimsWriter& file, std::uint32_t index_a, std::uint32_t index_b, const RoundDepth& depth);

}  // namespace sunder::solid
