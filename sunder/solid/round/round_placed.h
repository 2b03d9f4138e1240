// What exact methods ask of one placed body, answered for every kind of body. For the sources of solid/round.
#pragma once

#include <sunder/certificate/common_point.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/disc/round_shape.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace sunder::solid {

namespace round_detail {

// The point of a hull's core that the combination makes.
inline WeightedPoint weighted(const PlacedRound& body, const RoundCombination& c) {
  WeightedPoint point;
  point.count = c.count();
  for (std::size_t k = 0; k < point.count; ++k) {
    point.points[k] = body.core[c.vertices[k]];
    point.weights[k] = c.weights[k];
  }
  return point;
}

inline constexpr Affine3 in_place{};
inline WeightedPoint weighted(const Point3& p) { return {1, {Posed3{p, &in_place, false}}, {1}}; }

inline bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

Combination exact(const RoundCombination& c);

// Of a point of the body's frame.
Vector3<Dyadic> exact_image(const PlacedRound& body, const Point3& p);

}  // namespace round_detail

// The size of the numbers that say where the body is, and how large it is.
double size_of(const PlacedRound& body);

// The body as predicates along the direction see it: of a hull its vertex that is furthest, or least far, looked for
// from `near`.
RoundShape shape_along(const PlacedRound& body, const WorldDirection& direction, End end, std::uint32_t near,
                       Cost& cost, StageTally& tally);

// positive: the body holds the point, and not on its boundary; zero: on its boundary; negative: it does not. Of hulls,
// as far as a point of the core tells, which `made` makes: whether the point is within the radius of it.
Sign side_of(const PlacedRound& body, const WeightedPoint& x, const RoundCombination& made, StageTally* tally);
Sign side_of(const PlacedRound& body, const ExactPoint3& x, const Combination& made);

// Is the point inside, as `inside` of docs/claims.md wants it? Of polyhedra nothing is asked: true.
bool is_inside(const PlacedRound& body, const ExactPoint3& x, const Combination& made);

// Of a polyhedron that has the point: the point moved towards its middle by 2^-bits of the way, and all weights that it
// then has. Of a body with a radius nothing.
std::optional<ExactPoint3> moved_in(const PlacedRound& body, const ExactPoint3& x, int bits, Combination& made);

// How a body makes a point that it holds; of a hull it is as `made`.
Combination made_by(const PlacedRound& body, const ExactPoint3& x, const Combination& made);
Combination made_by(const PlacedRound& curved, const ExactPoint3& x);

// A point of the body's core, as certificates number its points.
Combination in_points(const PlacedRound& body, Combination of_core);

// The point of a hull's core that the weights make; nothing of other bodies.
std::optional<PointOf> core_point(const PlacedRound& body, const std::vector<Weights::Part>& weights);

// A point that a curved body holds: near this one, which is off it by about 2^-bits of the body's size; of one that is
// hardly as large, a point of the core.
PointOf held_by(const PlacedRound& curved, const Vector3<Dyadic>& near, int bits);

// How far apart the cores are, where that and the radii tell all of two bodies: of hulls. Else nothing.
std::optional<PolyhedronDistance> distance_of_cores(const PlacedRound& a, const PlacedRound& b);

// The base, and the way to the top or the apex; nothing of bodies without an axis.
struct ExactAxis {
  Vector3<Dyadic> base, way;
};
std::optional<ExactAxis> axis_of(const PlacedRound& body);

// Directions out of a curved body at one of its points: across its planes, and across what is round there. Of hulls
// none.
std::vector<std::array<Dyadic, 3>> outward_directions(const PlacedRound& body, const ExactPoint3& x);

}  // namespace sunder::solid
