// Exact decisions about a curved body and a polyhedron of radius 0 whose cores are apart: what the search's evidence
// did not settle.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/round/round_body.h>

#include <array>
#include <cstdint>
#include <optional>

namespace sunder::solid {

// How a curved body and a polyhedron lie.
struct CurvedVerdict {
  Sign sign = Sign::zero;  // positive: they have points inside the curved body in common; zero: they touch it only
  // A common point, where they meet: `of_curved` first.
  std::optional<CommonPoint> point;
  // From the curved body to the polyhedron: where they are apart one that parts them, where they touch weakly. Not of
  // those that have more in common; of a cone it may be missing.
  std::optional<Vector3<Dyadic>> direction;
};

// Exact; nothing unless the first body is curved, and the second one a polyhedron. Requires cores that are apart; near:
// a vertex to begin with.
//   ellipsoid: the nearest point of the polyhedron to the centre, where the ellipsoid is a ball: the search of
//     exact_gjk.h.
//   cylinder: the same across the axis, of what of the polyhedron lies between the planes of base and top. O(n) exact
//     numbers a step.
//   cone: it meets the polyhedron where the base disc or an edge does, given that the axis does not: a facet that meets
//     it elsewhere is cut by the axis. Along an edge, signs of a quadratic. O(n) exact numbers.
std::optional<CurvedVerdict> curved_polyhedron(const PlacedRound& curved, const PlacedRound& polyhedron,
                                               std::uint32_t near, Cost& cost, StageTally& tally);
CurvedVerdict ellipsoid_polyhedron(const PlacedRound& ellipsoid, const PlacedRound& polyhedron, std::uint32_t near,
                                   Cost& cost, StageTally& tally);
CurvedVerdict cylinder_polyhedron(const PlacedRound& cylinder, const PlacedRound& polyhedron, StageTally& tally);
CurvedVerdict cone_polyhedron(const PlacedRound& cone, const PlacedRound& polyhedron, StageTally& tally);

}  // namespace sunder::solid
