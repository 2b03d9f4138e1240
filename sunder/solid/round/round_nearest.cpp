#include <sunder/base/contract.h>
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/round/round_nearest.h>
#include <sunder/solid/round/simple_numbers.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

// p + part (q - p)
PointOf moved(const PointOf& p, const PointOf& q, const Dyadic& part) {
  const Exact from = times(q.at.denominator, p.at.numerators()), to = times(p.at.denominator, q.at.numerators());
  return {exact_point(sum(from, times(part, to - from)), p.at.denominator * q.at.denominator), p.of_body};
}

// The part of the way that the radius is, which is less than 1, from below: as near as 2^-bits.
Dyadic part_of_way(double radius, const NearPoints& ends, int bits) {
  const Dyadic limit = Dyadic(radius) * Dyadic(radius) * ends.square.denominator;
  Dyadic low(0.0), step(0.5);
  if (limit.sign() == Sign::zero) return low;
  for (int k = 0; k < bits; ++k, step = step.scaled(-1)) {
    const Dyadic next = low + step;
    if ((next * next * ends.square.numerator - limit).sign() != Sign::positive) low = next;
  }
  return low;
}

}  // namespace

RoundGap::RoundGap(const PlacedRound& a, const PlacedRound& b, const WorldDirection& direction, std::uint32_t near_a,
                   std::uint32_t near_b, Cost& cost, StageTally& tally)
    : direction_(direction),
      a_(shape_along(a, direction_, End::greatest, near_a, cost, tally)),
      b_(shape_along(b, direction_, End::least, near_b, cost, tally)),
      tally_(tally) {}

NearPoints::NearPoints(PointOf p, PointOf q) : of_a(std::move(p)), of_b(std::move(q)) {
  const std::array<Dyadic, 3> way = way_between(of_a, of_b);
  const Dyadic weight = of_a.at.denominator * of_b.at.denominator;
  square = {way[0] * way[0] + way[1] * way[1] + way[2] * way[2], weight * weight};
}

NearPoints points_of_cores(const PlacedRound& a, const PlacedRound& b) {
  const auto point = [](const PlacedRound& body) {
    auto of_core = core_point(body, {{0, Dyadic(1.0)}});
    return of_core ? *std::move(of_core) : held_by(body, round_detail::exact_image(body, body.shape.points[0]), 48);
  };
  return {point(a), point(b)};
}

PointOf towards(PointOf of_core, double radius, const PointOf& to) {
  if (radius == 0) return of_core;
  const ExactFraction between = NearPoints(of_core, to).square;
  const Dyadic& square = between.numerator;
  const Dyadic limit = Dyadic(radius) * Dyadic(radius) * between.denominator;
  if ((limit - square).sign() != Sign::negative) return {to.at, of_core.of_body};
  // The part of the way: the root of limit / square, in doubles, once more by Newton's method, and less by 2^-98 of it.
  const std::int64_t shift = (limit.top() - square.top()) / 2;
  const double about = std::sqrt(nearest_ratio(limit.scaled(-2 * shift), square));
  const Dyadic s(about);
  const double rest = nearest_ratio(limit.scaled(-2 * shift) - s * s * square, s * square.scaled(1));
  Dyadic part = (s + Dyadic(rest) - s.scaled(-98)).scaled(shift);
  const auto is_within = [&] { return (part * part * square - limit).sign() != Sign::positive; };
  for (int k = 90; !is_within() && k > 0; k -= 10) part = (s - s.scaled(-k)).scaled(shift);
  return moved(of_core, to, part);
}

NearPoints points_nearer_than(double least, const ClosestPoints& cores, double radius_a, double radius_b) {
  PointOf p = towards(cores.of_a, radius_a, cores.of_b);
  PointOf q = towards(cores.of_b, radius_b, p);
  NearPoints found(std::move(p), std::move(q));
  // Nearer and nearer to what the radii leave.
  const NearPoints ends(cores.of_a, cores.of_b);
  for (int bits = 128; std::isfinite(least) && !found.nearer_than(least); bits *= 2) {
    found = NearPoints(moved(cores.of_a, cores.of_b, part_of_way(radius_a, ends, bits)),
                       moved(cores.of_b, cores.of_a, part_of_way(radius_b, ends, bits)));
  }
  return found;
}

std::vector<WorldDirection> simple_directions(const PlacedRound& a, const PlacedRound& b, const Point3& near) {
  std::vector<WorldDirection> found;
  const double largest = std::max({std::fabs(near.x), std::fabs(near.y), std::fabs(near.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return found;
  const Point3 d{near.x / largest, near.y / largest, near.z / largest};
  for (const int bits : {40, 20, 10}) found.emplace_back(snapped(d, bits));
  found.emplace_back(simple_fractions(d).numerators());
  for (const PlacedRound* body : {&a, &b}) {
    const auto axis = axis_of(*body);
    if (!axis) continue;
    const Exact exact_near = coordinates<Dyadic>(d);
    const Exact& way = axis->way;
    found.emplace_back(dot(way, exact_near).sign() == Sign::negative ? Exact{-way.x, -way.y, -way.z} : way);
  }
  const PolyhedronDistance cores = polyhedron_polyhedron_distance(a.body.core(), a.pose, b.body.core(), b.pose);
  if (const ClosestFeatures* closest = closest_of(cores)) {
    const ClosestPoints points = closest_points(*closest);
    const std::array<Dyadic, 3> way = way_between(points.of_a, points.of_b);
    found.emplace_back(Exact{way[0], way[1], way[2]});
  }
  return found;
}

}  // namespace sunder::solid
