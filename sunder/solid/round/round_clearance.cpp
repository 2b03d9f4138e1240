#include <sunder/base/contract.h>
#include <sunder/predicate/stages.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/round/round_claims.h>
#include <sunder/solid/round/round_clearance.h>

#include <algorithm>
#include <cmath>

namespace sunder::solid {

namespace {

// radius / sqrt(square / over), which is less than 1, from below: between two numbers that come nearer as one likes.
class PartOfWay {
 public:
  PartOfWay(double radius, const Dyadic& square, const Dyadic& over)
      : square_(square), limit_(Dyadic(radius) * Dyadic(radius) * over) {
    // Between 0 and 1, or nearer where doubles tell.
    const double about = std::sqrt(nearest_ratio(limit_, square)), low = about * (1 - 0x1p-48);
    low_ = is_within(Dyadic(low)) ? Dyadic(low) : Dyadic(0.0);
    const Dyadic high(about * (1 + 0x1p-48));
    high_ = is_within(high) ? Dyadic(1.0) : high;
  }
  void halve() {
    const Dyadic middle = (low_ + high_).scaled(-1);
    (is_within(middle) ? low_ : high_) = middle;
  }
  const Dyadic& value() const { return low_; }

 private:
  bool is_within(const Dyadic& x) const { return (x * x * square_ - limit_).sign() != Sign::positive; }

  Dyadic square_, limit_, low_, high_;
};

// p + part (q - p)
PointOf moved(const PointOf& p, const PointOf& q, const Dyadic& part) {
  PointOf x{{}, p.denominator * q.denominator, p.of_body};
  for (std::size_t k = 0; k < 3; ++k) {
    const Dyadic from = p.coordinates[k] * q.denominator, to = q.coordinates[k] * p.denominator;
    x.coordinates[k] = from + part * (to - from);
  }
  return x;
}

}  // namespace

RoundClearance round_clearance(const PlacedRound& a, const PlacedRound& b, double least) {
  SUNDER_REQUIRE(!a.body.is_curved() && !b.body.is_curved() && least > 0 && std::isfinite(least));
  const PolyhedronDistance cores = polyhedron_polyhedron_distance(a.body.core(), a.pose, b.body.core(), b.pose);
  RoundClearance found;
  const Dyadic radii = Dyadic(a.radius()) + Dyadic(b.radius()), all = radii + Dyadic(least);
  if (cores.closest) {
    const auto [square, over] = cores.closest->squared();
    const ClosestPoints points = closest_points(*cores.closest);
    const Interval distance = cores.distance() - (Interval(a.radius()) + Interval(b.radius()));
    found.distance = {std::max(distance.low, 0.0), std::max(distance.high, 0.0)};
    if ((all * all * over - square).sign() != Sign::positive) {
      found.kept = true;
      found.direction = way_between(points.of_a, points.of_b);
      return found;
    }
    if ((radii * radii * over - square).sign() == Sign::negative) {
      PartOfWay of_a(a.radius(), square, over), of_b(b.radius(), square, over);
      const Dyadic c(least), limit = c * c * over;
      for (;; of_a.halve(), of_b.halve()) {
        const Dyadic rest = Dyadic(1.0) - of_a.value() - of_b.value();
        if ((rest * rest * square - limit).sign() == Sign::negative) break;
      }
      found.of_a = moved(points.of_a, points.of_b, of_a.value());
      found.of_b = moved(points.of_b, points.of_a, of_b.value());
      return found;
    }
  }
  const RoundAnswer answer = round_round(a, b);
  const CommonPoint common = common_point_of(a, b, answer.evidence);
  found.of_a = {common.coordinates, common.denominator, common.of_a};
  found.of_b = {common.coordinates, common.denominator, common.of_b};
  found.distance = {0, 0};
  return found;
}

RoundClearance round_clearance(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                               double least) {
  return round_clearance(PlacedRound(a, pose_a), PlacedRound(b, pose_b), least);
}

void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, double least,
                const RoundClearance& clearance) {
  if (clearance.kept) return pairs.add_clearance(index_a, index_b, least, clearance.direction);
  pairs.add_clearance_broken(index_a, index_b, least, clearance.of_a, clearance.of_b);
}

}  // namespace sunder::solid
