// The nearest points of two placed bodies with a radius: what a search proposes of them, as directions and as points in
// exact numbers. For the sources of solid/round.
#pragma once

#include <sunder/certificate/pair_claims.h>
#include <sunder/number/root.h>
#include <sunder/number/vector.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_placed.h>
#include <sunder/solid/round/round_search.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::solid {

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

// A point of each body, and the square of how far apart they are.
struct NearPoints {
  PointOf of_a, of_b;
  ExactFraction square;

  NearPoints(PointOf p, PointOf q);

  // Are they nearer to each other than that? Exact.
  bool nearer_than(double least) const { return compare_root(square, least) == Sign::negative; }
};

// A point of a search, or a weight of one.
inline Dyadic exact(double x) { return Dyadic(x); }
inline Dyadic exact(const DoubleDouble& x) { return Dyadic(x.high) + Dyadic(x.low); }

// A point of each core: where a search makes none that are nearer.
NearPoints points_of_cores(const PlacedRound& a, const PlacedRound& b);

// As far as the radius from a point of a core towards the other point, or a little less; that point, where it is as
// near.
PointOf towards(PointOf of_core, double radius, const PointOf& to);

// Of two hulls, whose cores are nearest at these points: points of both that are nearer to each other than `least`,
// which may be infinite. Requires that the cores are further apart than the radii together, and nearer than these and
// `least`.
NearPoints points_nearer_than(double least, const ClosestPoints& cores, double radius_a, double radius_b);

// How far the points are apart that the simplex makes of cores and of curved bodies, squared: of one that is nearly
// flat that is more than search.distance2. Infinite where it makes none.
template <class Real>
Real way2_of(const RoundSearch<Real>& search) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto mean = mean_nearest(search.simplex);
  if (!mean) return infinity;
  VectorOf<Real> way{};
  for (const auto& part : *mean) {
    const auto& slot = search.support.slots[part.a];
    way = round_detail::sum<Real>(way, part.weight, minus(slot.of_a, slot.of_b));
  }
  const Real length2 = dot(way, way) / (mean->total * mean->total);
  return length2 >= Real(0) ? length2 : Real(infinity);
}

// The points of both bodies that the simplex makes. Nothing where it makes none.
template <class Real>
std::optional<NearPoints> near_points(const RoundSearch<Real>& search, const PlacedRound& a, const PlacedRound& b) {
  const auto mean = mean_nearest(search.simplex);
  if (!mean) return std::nullopt;
  const auto& origin = a.core.pose.translation;
  int shift = 0;
  std::frexp(search.simplex.scale, &shift);
  constexpr int bits = std::is_same_v<Real, double> ? 48 : 98;
  const auto point = [&](const PlacedRound& body) {
    VectorOf<Real> sum{};
    std::vector<Weights::Part> parts;
    for (const auto& part : *mean) {
      const auto& slot = search.support.slots[part.a];
      const bool is_a = &body == &a;
      sum = round_detail::sum<Real>(sum, part.weight / mean->total, is_a ? slot.of_a : slot.of_b);
      parts.push_back({is_a ? slot.vertex_a : slot.vertex_b, exact(part.weight)});
    }
    if (auto of_core = core_point(body, parts)) return *std::move(of_core);
    const auto part = [&](const Real& x, std::size_t i) { return Dyadic(origin[i]) + exact(x).scaled(1 - shift); };
    return held_by(body, {part(sum.x, 0), part(sum.y, 1), part(sum.z, 2)}, bits);
  };
  PointOf p = point(a), q = point(b);
  p = towards(std::move(p), a.body.rounding(), q);
  q = towards(std::move(q), b.body.rounding(), p);
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
  const auto made = made_of(search);
  if (!made) return std::nullopt;
  const auto place = [&](const PlacedRound& body, bool is_a) -> std::optional<WeightedPoint> {
    if (const RoundCombination& of_core = is_a ? made->a : made->b; of_core.count() > 0) {
      return round_detail::weighted(body, of_core);
    }
    // A little inwards, because of rounding.
    const VectorOf<Real>& at = is_a ? made->of_a : made->of_b;
    const VectorOf<Real> inwards = minus(search.support.middle_of(is_a), at);
    const Point3 x = search.support.in_world(round_detail::sum<Real>(at, Real(0x1p-44), inwards));
    if (!round_detail::is_finite(x)) return std::nullopt;
    const WeightedPoint point = round_detail::weighted(x);
    return side_of(body.shape, point, &tally) == Sign::negative ? std::nullopt : std::optional(point);
  };
  const auto p = place(a, true), q = place(b, false);
  return p && q ? std::optional(NearPlaces{*p, *q}) : std::nullopt;
}

// Runs the search from a direction, until it comes no nearer. After each step it asks whether that will do:
//   seen.parts(search, w)  w is the last point along search.direction
//   seen.nears(search)     the simplex is the nearest one so far
// Returns whether one of them said so.
template <class Real, class Seen>
bool search_nearest(RoundSearch<Real>& search, const VectorOf<Real>& first, Seen& seen, Cost& cost) {
  search.begin(first);
  return search.run(
             {round_steps<Real>}, cost, [&](const auto& w) { return seen.parts(search, w); },
             [&](bool is_nearer) { return is_nearer && seen.nears(search); }) == GjkEnd::stopped;
}

// Directions in which bodies that people give often are exactly as far apart as they are: near this one, simple
// numbers; the axes of cylinders and cones; the shortest way between the cores.
std::vector<WorldDirection> simple_directions(const PlacedRound& a, const PlacedRound& b, const Point3& near);

}  // namespace sunder::solid
