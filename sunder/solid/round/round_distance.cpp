#include <sunder/base/contract.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/vector.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_nearest.h>
#include <sunder/solid/round/round_round.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder::solid {

namespace {

constexpr double largest_double = std::numeric_limits<double>::max(),
                 infinity = std::numeric_limits<double>::infinity();

std::shared_ptr<const std::array<PointOf, 2>> shared(NearPoints points) {
  return std::make_shared<const std::array<PointOf, 2>>(std::array{std::move(points.of_a), std::move(points.of_b)});
}

// The root of a quotient, in doubles, about.
double root_about(const Dyadic& numerator, const Dyadic& denominator) {
  if (numerator.sign() == Sign::zero) return 0;
  std::int64_t shift = numerator.top() - denominator.top();
  shift -= shift & 1;
  const int power = static_cast<int>(std::clamp<std::int64_t>(shift / 2, -2000, 2000));
  return std::ldexp(std::sqrt(nearest_ratio(numerator.scaled(-shift), denominator)), power);
}

// The greatest finite double, not below 0, for which it holds, if it holds for 0 and for all below one that it holds
// for. Looks from a number that is about it.
template <class Holds>
double greatest(double about, const Holds& holds) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };  // in the order of the numbers
  const auto at = [](std::uint64_t k) { return std::bit_cast<double>(k); };
  const std::uint64_t most = bits(largest_double);
  std::uint64_t low = about > 0 ? std::min(bits(about), most) : 0, high = low + 1;
  for (std::uint64_t step = 1; low > 0 && !holds(at(low)); step *= 2) {
    high = low;
    low -= std::min(low, step);
  }
  if (high == low + 1) {
    for (std::uint64_t step = 1; high <= most && holds(at(high)); step *= 2) {
      low = high;
      high = low + std::min(step, most + 1 - low);
    }
  }
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (holds(at(middle)) ? low : high) = middle;
  }
  return at(low);
}

// Two hulls whose cores are apart: sqrt(square / over) less the radii.
Interval less_radii(const Dyadic& square, const Dyadic& over, const Dyadic& radii) {
  const auto compared = [&](double x) {
    const Dyadic all = radii + Dyadic(x);
    return (all * all * over - square).sign();
  };
  const double about =
      nearest_ratio(square - radii * radii * over, over) / (root_about(square, over) + radii.nearest());
  const double low = greatest(about, [&](double x) { return compared(x) != Sign::positive; });
  return {low, compared(low) == Sign::zero ? low : std::nextafter(low, infinity)};
}

// The best that a search sees.
class DistanceSearch {
 public:
  DistanceSearch(const PlacedRound& a, const PlacedRound& b, RoundDistance& found, StageTally& tally)
      : a_(a), b_(b), found_(found), tally_(tally) {
    found_.distance = {0, infinity};
  }

  void run() {
    RoundSearch<double> first(a_, b_);
    search_nearest(first, {}, *this, found_.cost);
    const Point3 d = best_;
    RoundSearch<DoubleDouble> second(a_, b_);
    best_gap_ = -infinity;
    const bool is_some = std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z);
    search_nearest(second, is_some ? Vector3<DoubleDouble>{d.x, d.y, d.z} : Vector3<DoubleDouble>{}, *this,
                   found_.cost);
    // Where the search ends in a tetrahedron that holds the origin, that is the nearest.
    const bool is_last = !nearest_ || way2_of(second) < least_way2_;
    if (auto points = near_points(is_last ? second : *nearest_, a_, b_)) take(std::move(*points));
  }

  template <class Real>
  bool parts(const RoundSearch<Real>& search, const DifferenceVertexOf<Real>& w) {
    const Real length = round_detail::root_of(dot(search.direction, search.direction));
    const double gap = nearest(search.gap_at(w) / length - reach(search));
    if (!(gap > best_gap_)) return false;
    best_gap_ = gap;
    scale_ = search.simplex.scale;
    best_ = rounded(search.direction);
    best_exact_ = {exact(search.direction.x), exact(search.direction.y), exact(search.direction.z)};
    near_a_ = search.support.slots[w.a].vertex_a;
    near_b_ = search.support.slots[w.a].vertex_b;
    return false;
  }
  template <class Real>
  bool nears(const RoundSearch<Real>& search) {
    if constexpr (std::is_same_v<Real, DoubleDouble>) {
      const DoubleDouble way2 = way2_of(search);
      if (way2 < least_way2_) {
        nearest_.emplace(search);
        least_way2_ = way2;
      }
    }
    // Nothing is won any more where the points are hardly further apart than the direction tells.
    const double length = nearest(round_detail::root_of(search.distance2) - reach(search));
    return std::is_same_v<Real, DoubleDouble> && length - best_gap_ < 0x1p-56 * length;
  }

  void take(const WorldDirection& direction) {
    const RoundGap gap(a_, b_, direction, near_a_, near_b_, found_.cost, tally_);
    const double better = std::nextafter(found_.distance.low, infinity);
    if (!std::isfinite(better) || gap.against(better) == Sign::negative) return;
    const double low =
        greatest(best_gap_ / scale_, [&](double x) { return x == 0 || gap.against(x) != Sign::negative; });
    found_.distance.low = low;
    found_.direction = direction;
  }
  void take(NearPoints points) {
    const auto compared = [&](double x) { return (Dyadic(x) * Dyadic(x) * points.over - points.square).sign(); };
    double high =
        greatest(root_about(points.square, points.over), [&](double x) { return compared(x) != Sign::positive; });
    if (compared(high) == Sign::negative) high = std::nextafter(high, infinity);
    if (high >= found_.distance.high && found_.points) return;
    found_.distance.high = high;
    found_.points = shared(std::move(points));
  }
  void take_best() {
    if (best_exact_) take(WorldDirection(*best_exact_));
  }

  const Point3& best() const { return best_; }

 private:
  // In the precision of the search: what it has of it is rounded.
  template <class Real>
  Real reach(const RoundSearch<Real>& search) const {
    const auto of = [&](const PlacedRound& p) -> Real {
      return p.body.is_curved() ? 0 : p.radius() * search.simplex.scale;
    };
    return of(a_) + of(b_);
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
  RoundDistance& found_;
  StageTally& tally_;
  std::optional<RoundSearch<DoubleDouble>> nearest_;  // where its simplex is nearest
  double best_gap_ = -infinity, scale_ = 1;
  DoubleDouble least_way2_ = infinity;
  Point3 best_{};
  std::optional<Vector3<Dyadic>> best_exact_;
  std::uint32_t near_a_ = 0, near_b_ = 0;
};

void of_hulls(const PlacedRound& a, const PlacedRound& b, RoundDistance& found) {
  const PolyhedronDistance cores = polyhedron_polyhedron_distance(a.body.core(), a.pose, b.body.core(), b.pose);
  found.cost = cores.answer.cost;
  const auto [square, over] = cores.closest->squared();
  found.distance = less_radii(square, over, Dyadic(a.radius()) + Dyadic(b.radius()));
  const ClosestPoints points = closest_points(*cores.closest);
  const std::array<Dyadic, 3> way = way_between(points.of_a, points.of_b);
  found.direction = WorldDirection(Vector3<Dyadic>{way[0], way[1], way[2]});
  found.points =
      shared(points_nearer_than(std::nextafter(found.distance.high, infinity), points, a.radius(), b.radius()));
}

}  // namespace

RoundDistance round_distance(const PlacedRound& a, const PlacedRound& b) {
  RoundDistance found;
  const RoundAnswer answer = round_round(a, b);
  StageTally tally;
  if (answer.meet()) {
    const CommonPoint common = common_point_of(a, b, answer.evidence);
    found.points = std::make_shared<const std::array<PointOf, 2>>(
        std::array{PointOf{common.at, common.of_a}, PointOf{common.at, common.of_b}});
    found.distance = {0, 0};
  } else if (!a.body.is_curved() && !b.body.is_curved()) {
    of_hulls(a, b, found);
  } else {
    DistanceSearch search(a, b, found, tally);
    search.run();
    if (!answer.undecided()) {
      search.take_best();
      const Interval& d = found.distance;
      if (d.low < d.high) {
        for (const WorldDirection& direction : simple_directions(a, b, search.best())) search.take(direction);
      }
    }
  }
  found.cost.probes += answer.cost.probes;
  found.cost.iterations += answer.cost.iterations;
  found.cost.exact += answer.cost.exact + tally.exact;
  return found;
}

RoundDistance round_distance(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b) {
  return round_distance(PlacedRound(a, pose_a), PlacedRound(b, pose_b));
}

void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const RoundDistance& distance) {
  const auto [low, high] = distance.distance;
  if (low > 0) {
    const Vector3<Dyadic> d = distance.direction->exact();
    pairs.add_clearance(index_a, index_b, low, {d.x, d.y, d.z});
  }
  const auto& [of_a, of_b] = *distance.points;
  const NearPoints points(of_a, of_b);
  for (double least = high; std::isfinite(least); least = std::nextafter(least, infinity)) {
    if (least == 0 || !points.nearer_than(least)) continue;
    return pairs.add_clearance_broken(index_a, index_b, least, of_a, of_b);
  }
}

}  // namespace sunder::solid
