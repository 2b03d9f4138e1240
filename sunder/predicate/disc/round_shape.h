// Placed bodies with a radius: does a direction part two of them, does one hold a point? Exact, for every finite
// double. Also called: support function; separating plane of spheres, capsules, cylinders, cones, ellipsoids.
//
// Points are mapped exactly by the pose x -> L x + t, the radius r stays; but of an ellipsoid the ball is mapped. What
// a body reaches along d is that of its one or two ends, each a point P and a root:
//   hull       P d + r sqrt(d d) for the vertex P that is furthest along d
//   cylinder   P d + r sqrt(|d x a|^2 / a a) for base and top, a the axis
//   cone       the same for the base; P d for the apex
//   ellipsoid  P d + r sqrt(|L^T d|^2) for the centre
// So every statement is the sign of g - sqrt(u) - sqrt(v), and where nothing is left to floating point it comes from
// squares. Intervals of doubles come first, then exact numbers.
#pragma once

#include <sunder/number/exact_fraction.h>
#include <sunder/predicate/disc/round_kind.h>
#include <sunder/predicate/exact_point.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <cstdint>
#include <vector>

namespace sunder {

// One body as these predicates see it. The pose is looked at later: it must stay.
struct RoundShape {
  RoundKind kind = RoundKind::hull;
  // hull: the vertex that is meant. cylinder, cone: base, and top or apex, whose images differ. ellipsoid: the centre.
  std::array<Point3, 2> points{};
  const Affine3* pose = nullptr;
  double radius = 0;  // not negative

  std::size_t ends() const { return kind == RoundKind::cylinder || kind == RoundKind::cone ? 2 : 1; }
};

// A point: the sum of weight times image over the sum of the weights. Weights are positive.
struct WeightedPoint {
  std::uint8_t count = 0;  // 1 to 4
  std::array<Posed3, 4> points{};
  std::array<double, 4> weights{};
};

ExactPoint3 exact_point(const WeightedPoint& point);

// positive: the plane across the direction parts A from B strictly, A before B. zero: weakly, and they come up to it.
// Of hulls: as far as the vertices named are the furthest of A, the least far of B. Requires a direction other than 0.
Sign gap_sign(const WorldDirection& direction, const RoundShape& a, const RoundShape& b, StageTally* tally = nullptr);

// Of three numbers: the sign of g - sqrt(u) - sqrt(v), where u and v are not negative.
Sign gap_sign(const Dyadic& g, const Dyadic& u, const Dyadic& v);

// positive: along the direction B begins further beyond the end of A than `least`, in units of the direction's length;
// zero: exactly so far; negative: less far. Hulls as of gap_sign. Requires a direction other than 0, and a finite
// `least` that is not negative.
Sign clear_sign(const WorldDirection& direction, const RoundShape& a, const RoundShape& b, double least,
                StageTally* tally = nullptr);

// How far the body reaches along a direction: as far as the furthest of q + sqrt(square). Exact.
struct ReachAlong {
  Dyadic q;
  ExactFraction square;
};
std::vector<ReachAlong> reaches_along(const Vector3<Dyadic>& direction, const RoundShape& shape);

// positive: the body holds the point, and not on its boundary; zero: on its boundary; negative: it does not. Requires
// that it is no hull; of an ellipsoid, that L has an inverse.
Sign side_of(const RoundShape& shape, const WeightedPoint& point, StageTally* tally = nullptr);
Sign side_of(const RoundShape& shape, const ExactPoint3& point);

// positive: the points are nearer to each other than both radii together; zero: so far apart.
Sign nearness(const WeightedPoint& p, double radius_p, const WeightedPoint& q, double radius_q,
              StageTally* tally = nullptr);
Sign nearness(const ExactPoint3& p, double radius_p, const ExactPoint3& q, double radius_q);

// positive: the points are nearer to each other than both radii and `least` together; zero: so far apart. Requires a
// finite `least` that is not negative.
Sign nearness_within(const WeightedPoint& p, double radius_p, const WeightedPoint& q, double radius_q, double least,
                     StageTally* tally = nullptr);

// The adjoint of the linear part: L^-1 times the determinant; row by row.
std::array<Dyadic, 9> adjoint(const Affine3& pose);

}  // namespace sunder
