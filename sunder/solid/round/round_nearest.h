// The nearest points of two placed bodies with a radius: what a search proposes of them, as directions and as points in
// exact numbers. For the sources of solid/round.
#pragma once

#include <sunder/certificate/pair_claims.h>
#include <sunder/predicate/stages.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/extreme_vertex.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_search.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace sunder::solid {

namespace nearest_detail {
inline constexpr Affine3 in_place{};
}

// A direction, and the ends of both bodies along it.
class RoundGap {
 public:
  // near_a, near_b: vertices of hulls to look from. Requires a direction other than 0. Keeps a reference to the bodies.
  RoundGap(const PlacedRound& a, const PlacedRound& b, const WorldDirection& direction, std::uint32_t near_a,
           std::uint32_t near_b, Cost& cost, StageTally& tally);

  // positive: B begins further beyond the end of A than that; zero: exactly so far. Exact.
  Sign against(double least) const { return clear_sign(direction_, a_, b_, least, &tally_); }

  const WorldDirection& direction() const { return direction_; }

 private:
  WorldDirection direction_;
  RoundShape a_, b_;
  StageTally& tally_;
};

// A point of each body, and the square of how far apart they are: numerator over denominator, which is positive.
struct NearPoints {
  PointOf of_a, of_b;
  Dyadic square, over;

  NearPoints(PointOf p, PointOf q);

  // Are they nearer to each other than that? Exact.
  bool nearer_than(double least) const {
    return (square - Dyadic(least) * Dyadic(least) * over).sign() == Sign::negative;
  }
};

// A point of a search, or a weight of one.
inline Dyadic exact(double x) { return Dyadic(x); }
inline Dyadic exact(const DoubleDouble& x) { return Dyadic(x.high) + Dyadic(x.low); }

// A point that the curved body holds: near this one, which is off it by about 2^-bits of the body's size; of one that
// is hardly as large, a point of the core.
PointOf held_by(const PlacedRound& curved, const Vector3<Dyadic>& near, int bits);

// The point of a hull's core that these weights make.
PointOf of_core(const PlacedRound& hull, const std::vector<Weights::Part>& weights);

// As far as the radius from a point of a core towards the other point, or a little less; that point, where it is as
// near.
PointOf towards(const PointOf& of_core, double radius, const PointOf& to);

// Of two hulls, whose cores are nearest at these points: points of both that are nearer to each other than `least`,
// which may be infinite. Requires that the cores are further apart than the radii together, and nearer than these and
// `least`.
NearPoints points_nearer_than(double least, const ClosestPoints& cores, double radius_a, double radius_b);

// How far the points are apart that the simplex makes of cores and of curved bodies, squared: of one that is nearly
// flat that is more than search.distance2. Infinite where it makes none.
template <class Real>
Real way2_of(const RoundSearch<Real>& search) {
  const std::array<Real, 4> weights = weights_of_nearest(search.simplex);
  Real total = 0;
  VectorOf<Real> way{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(search.simplex.count); ++k) {
    if (!(weights[k] > Real(0))) continue;
    total = total + weights[k];
    way = round_detail::sum<Real>(way, weights[k], search.simplex.vertex[k].at);
  }
  const Real length2 = dot(way, way) / (total * total);
  return length2 >= Real(0) ? length2 : Real(std::numeric_limits<double>::infinity());
}

// The points of both bodies that the simplex makes. Nothing where it makes none.
template <class Real>
std::optional<NearPoints> near_points(const RoundSearch<Real>& search, const PlacedRound& a, const PlacedRound& b) {
  if (search.simplex.count == 0) return std::nullopt;
  const std::array<Real, 4> weights = weights_of_nearest(search.simplex);
  Real total = 0;
  const std::size_t n = static_cast<std::size_t>(search.simplex.count);
  for (std::size_t k = 0; k < n; ++k) {
    if (weights[k] > Real(0)) total = total + weights[k];
  }
  if (!(total > Real(0)) || !std::isfinite(nearest(total))) return std::nullopt;
  const auto& origin = a.core.pose.translation;
  int shift = 0;
  std::frexp(search.simplex.scale, &shift);
  constexpr int bits = std::is_same_v<Real, double> ? 48 : 98;
  const auto point = [&](const PlacedRound& body) {
    VectorOf<Real> sum{};
    std::vector<Weights::Part> parts;
    for (std::size_t k = 0; k < n; ++k) {
      if (!(weights[k] > Real(0))) continue;
      const auto& slot = search.slots[search.simplex.vertex[k].a];
      const bool is_a = &body == &a;
      sum = round_detail::sum<Real>(sum, weights[k] / total, is_a ? slot.of_a : slot.of_b);
      parts.push_back({is_a ? slot.vertex_a : slot.vertex_b, exact(weights[k])});
    }
    if (!body.body.is_curved()) return of_core(body, parts);
    const auto part = [&](const Real& x, std::size_t i) { return Dyadic(origin[i]) + exact(x).scaled(1 - shift); };
    return held_by(body, {part(sum.x, 0), part(sum.y, 1), part(sum.z, 2)}, bits);
  };
  PointOf p = point(a), q = point(b);
  if (!a.body.is_curved()) p = towards(p, a.radius(), q);
  if (!b.body.is_curved()) q = towards(q, b.radius(), p);
  return NearPoints(std::move(p), std::move(q));
}

// The same in doubles, so that filters tell of them: of hulls points of the cores; nothing where a curved body does not
// hold its point.
struct NearPlaces {
  WeightedPoint of_a, of_b;
};
template <class Real>
std::optional<NearPlaces> near_places(const RoundSearch<Real>& search, const PlacedRound& a, const PlacedRound& b,
                                      StageTally& tally) {
  if (search.simplex.count == 0) return std::nullopt;
  const std::array<Real, 4> weights = weights_of_nearest(search.simplex);
  const std::size_t n = static_cast<std::size_t>(search.simplex.count);
  Real total = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (weights[k] > Real(0)) total = total + weights[k];
  }
  if (!(total > Real(0)) || !std::isfinite(nearest(total))) return std::nullopt;
  const auto place = [&](const PlacedRound& body) -> std::optional<WeightedPoint> {
    const bool is_a = &body == &a;
    WeightedPoint point;
    VectorOf<Real> sum{};
    for (std::size_t k = 0; k < n; ++k) {
      const double weight = nearest(weights[k]);
      if (!(weight > 0)) continue;
      const auto& slot = search.slots[search.simplex.vertex[k].a];
      if (body.body.is_curved()) {
        sum = round_detail::sum<Real>(sum, weights[k] / total, is_a ? slot.of_a : slot.of_b);
        continue;
      }
      point.points[point.count] = body.core[is_a ? slot.vertex_a : slot.vertex_b];
      point.weights[point.count++] = weight;
    }
    if (!body.body.is_curved()) return point.count > 0 ? std::optional(point) : std::nullopt;
    // A little inwards, because of rounding.
    const VectorOf<Real> inwards = minus(search.middle_of(is_a), sum);
    const Point3 x = search.in_world(round_detail::sum<Real>(sum, Real(0x1p-44), inwards));
    if (!std::isfinite(x.x + x.y + x.z)) return std::nullopt;
    point = {1, {Posed3{x, &nearest_detail::in_place, false}}, {1}};
    return side_of(body.shape, point, &tally) == Sign::negative ? std::nullopt : std::optional(point);
  };
  const auto p = place(a), q = place(b);
  return p && q ? std::optional(NearPlaces{*p, *q}) : std::nullopt;
}

// Runs the search from a direction, until it comes no nearer. After each step it asks whether that will do:
//   seen.parts(search, w)  w is the last point along search.direction
//   seen.nears(search)     the simplex is the nearest one so far
// Returns whether one of them said so.
template <class Real, class Seen>
bool search_nearest(RoundSearch<Real>& search, const VectorOf<Real>& first, Seen& seen, Cost& cost) {
  search.simplex.count = 0;
  search.direction = dot(first, first) > Real(0) ? first : search.first_direction();
  Real nearest2 = std::numeric_limits<double>::infinity();
  int in_vain = 0;
  for (int i = 0; i < search.most_iterations; ++i) {
    ++cost.iterations;
    const DifferenceVertexOf<Real> w = search.probe(cost);
    if (seen.parts(search, w)) return true;
    if (!search.gains_by(w) || !search.step_to(w)) break;
    if (search.distance2 < nearest2) {
      nearest2 = search.distance2;
      in_vain = 0;
      if (seen.nears(search)) return true;
    } else if (++in_vain == 4) {
      break;
    }
  }
  return false;
}

// Directions in which bodies that people give often are exactly as far apart as they are: near this one, simple
// numbers; the axes of cylinders and cones; the shortest way between the cores.
std::vector<WorldDirection> simple_directions(const PlacedRound& a, const PlacedRound& b, const Point3& near);

}  // namespace sunder::solid
