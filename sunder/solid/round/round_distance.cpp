#include <sunder/base/contract.h>
#include <sunder/number/root.h>
#include <sunder/number/vector.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_methods.h>
#include <sunder/solid/round/round_nearest.h>
#include <sunder/solid/round/round_placed.h>
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

// The root of a quotient, in doubles, about.
double root_about(const ExactFraction& square) {
  const auto& [numerator, denominator] = square;
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

// Two hulls whose cores are apart: sqrt(square) less the radii.
Interval less_radii(const ExactFraction& square, const Dyadic& radii) {
  const auto compared = [&](double x) { return compare_root(square, radii + Dyadic(x)); };
  const double about = nearest_ratio(square.numerator - radii * radii * square.denominator, square.denominator) /
                       (root_about(square) + radii.nearest());
  const double low = greatest(about, [&](double x) { return compared(x) != Sign::negative; });
  return {low, compared(low) == Sign::zero ? low : std::nextafter(low, infinity)};
}

// The best that a search sees.
class DistanceSearch {
 public:
  DistanceSearch(const PlacedRound& a, const PlacedRound& b, Cost& cost, StageTally& tally)
      : a_(a), b_(b), cost_(cost), tally_(tally) {}

  // Of bodies of which round_round gave this answer, which do not meet as far as it says.
  RoundDistanceEvidence decide(const RoundAnswer& answer) {
    run();
    std::array<PointOf, 2> points{std::move(points_->of_a), std::move(points_->of_b)};
    if (distance_.high == 0) {
      auto& [of_a, of_b] = points;
      return ExactCommonPoint{std::make_shared<const CommonPoint>(
          CommonPoint{std::move(of_a.at), std::move(of_a.of_body), std::move(of_b.of_body)})};
    }
    if (answer.undecided()) {
      return PerhapsApart{distance_.high, std::make_shared<const std::array<PointOf, 2>>(std::move(points))};
    }
    if (best_exact_) take(WorldDirection(*best_exact_));
    if (distance_.low < distance_.high) {
      for (const WorldDirection& direction : simple_directions(a_, b_, best_)) take(direction);
    }
    if (!direction_) {  // they are less far apart than any double above 0, as far as is seen
      const std::array<Dyadic, 3> d = direction_of(a_, b_, answer.evidence);
      direction_ = WorldDirection(Vector3<Dyadic>{d[0], d[1], d[2]});
    }
    return CurvedApart{distance_, std::make_shared<const CurvedApart::Nearest>(
                                      CurvedApart::Nearest{*std::move(direction_), std::move(points)})};
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

 private:
  void run() {
    RoundSearch<double> first(a_, b_);
    search_nearest(first, {}, *this, cost_);
    const Point3 d = best_;
    RoundSearch<DoubleDouble> second(a_, b_);
    best_gap_ = -infinity;
    const bool is_some = std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z);
    search_nearest(second, is_some ? Vector3<DoubleDouble>{d.x, d.y, d.z} : Vector3<DoubleDouble>{}, *this, cost_);
    // Where the search ends in a tetrahedron that holds the origin, that is the nearest.
    const bool is_last = !nearest_ || way2_of(second) < least_way2_;
    auto points = near_points(is_last ? second : *nearest_, a_, b_);
    take(points ? *std::move(points) : points_of_cores(a_, b_));
  }

  void take(const WorldDirection& direction) {
    const RoundGap gap(a_, b_, direction, near_a_, near_b_, cost_, tally_);
    const double better = std::nextafter(distance_.low, infinity);
    if (!std::isfinite(better) || gap.against(better) == Sign::negative) return;
    const double low =
        greatest(best_gap_ / scale_, [&](double x) { return x == 0 || gap.against(x) != Sign::negative; });
    distance_.low = low;
    direction_ = direction;
  }
  void take(NearPoints points) {
    const auto compared = [&](double x) { return compare_root(points.square, x); };
    double high = greatest(root_about(points.square), [&](double x) { return compared(x) != Sign::negative; });
    if (compared(high) == Sign::positive) high = std::nextafter(high, infinity);
    distance_.high = high;
    points_ = std::move(points);
  }

  // In the precision of the search: what it has of it is rounded.
  template <class Real>
  Real reach(const RoundSearch<Real>& search) const {
    return Real(a_.body.rounding() * search.simplex.scale) + Real(b_.body.rounding() * search.simplex.scale);
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
  Cost& cost_;
  StageTally& tally_;
  Interval distance_{0, infinity};
  std::optional<WorldDirection> direction_;           // along which they are so far apart as `low`
  std::optional<NearPoints> points_;                  // that are no further apart than `high`
  std::optional<RoundSearch<DoubleDouble>> nearest_;  // where its simplex is nearest
  double best_gap_ = -infinity, scale_ = 1;
  DoubleDouble least_way2_ = infinity;
  Point3 best_{};
  std::optional<Vector3<Dyadic>> best_exact_;
  std::uint32_t near_a_ = 0, near_b_ = 0;
};

}  // namespace

Interval HullsApart::distance() const { return less_radii(cores.squared(), Dyadic(radius_a) + Dyadic(radius_b)); }

std::array<PointOf, 2> HullsApart::points() const {
  const ClosestPoints points = closest_points(cores);
  NearPoints found = points_nearer_than(std::nextafter(distance().high, infinity), points, radius_a, radius_b);
  return {std::move(found.of_a), std::move(found.of_b)};
}

WorldDirection HullsApart::direction() const {
  const ClosestPoints points = closest_points(cores);
  const std::array<Dyadic, 3> way = way_between(points.of_a, points.of_b);
  return WorldDirection(Vector3<Dyadic>{way[0], way[1], way[2]});
}

namespace {

// Of two hulls that are apart, polyhedra too.
std::optional<HullsApart> hulls_of(const RoundDistanceEvidence& evidence) {
  if (const auto* closest = std::get_if<ClosestFeatures>(&evidence)) return HullsApart{*closest};
  const auto* hulls = std::get_if<HullsApart>(&evidence);
  return hulls != nullptr ? std::optional(*hulls) : std::nullopt;
}

bool is_nearer(const HullsApart& one, const HullsApart& other) {
  // Is sqrt(n / d) < sqrt(m / e) + t?
  const auto [n, d] = one.cores.squared();
  const auto [m, e] = other.cores.squared();
  const Dyadic t = Dyadic(one.radius_a) + Dyadic(one.radius_b) - (Dyadic(other.radius_a) + Dyadic(other.radius_b));
  if (t.sign() != Sign::negative) {  // iff n / d - m / e - t^2 < 2 t sqrt(m / e)
    const Dyadic left = n * e - m * d - t * t * d * e;
    return left.sign() == Sign::negative || (left * left - (t * t * m * e * d * d).scaled(2)).sign() == Sign::negative;
  }
  // No: iff sqrt(m / e) - t <= sqrt(n / d).
  const Dyadic left = m * d - n * e - t * t * d * e;  // is it greater than -2 t sqrt(n / d), over d e?
  return left.sign() == Sign::positive && (left * left - (t * t * n * d * e * e).scaled(2)).sign() == Sign::positive;
}

// As nearest_of says; nothing of evidence that names vertices of both alone.
std::optional<std::array<PointOf, 2>> points_of(const RoundDistanceEvidence& evidence) {
  if (const auto* closest = std::get_if<ClosestFeatures>(&evidence)) {
    ClosestPoints points = closest_points(*closest);
    return std::array{std::move(points.of_a), std::move(points.of_b)};
  }
  if (const auto* hulls = std::get_if<HullsApart>(&evidence)) return hulls->points();
  if (const auto* curved = std::get_if<CurvedApart>(&evidence)) return curved->nearest->points;
  if (const auto* perhaps = std::get_if<PerhapsApart>(&evidence)) return *perhaps->points;
  if (const auto* exact = std::get_if<ExactCommonPoint>(&evidence)) {
    return std::array{PointOf{exact->point->at, exact->point->of_a}, PointOf{exact->point->at, exact->point->of_b}};
  }
  return std::nullopt;
}

}  // namespace

std::optional<bool> is_nearer(const RoundDistanceEvidence& one, const RoundDistanceEvidence& other) {
  const auto x = hulls_of(one), y = hulls_of(other);
  return x && y ? std::optional(is_nearer(*x, *y)) : std::nullopt;
}

std::optional<std::array<Point3, 2>> rounded_nearest(const RoundDistanceEvidence& evidence) {
  if (verdict_of(evidence) == Verdict::meet) return std::nullopt;
  if (const auto* closest = std::get_if<ClosestFeatures>(&evidence)) return closest->nearest_points();
  const auto points = points_of(evidence);
  return std::array{nearest((*points)[0].at), nearest((*points)[1].at)};
}

Interval distance_of(const RoundDistanceEvidence& evidence) {
  if (const auto* closest = std::get_if<ClosestFeatures>(&evidence)) return closest->distance();
  if (const auto* hulls = std::get_if<HullsApart>(&evidence)) return hulls->distance();
  if (const auto* curved = std::get_if<CurvedApart>(&evidence)) return curved->distance;
  if (const auto* perhaps = std::get_if<PerhapsApart>(&evidence)) return {0, perhaps->at_most};
  return {0, 0};
}

std::array<PointOf, 2> nearest_of(const PlacedRound& a, const PlacedRound& b, const RoundDistanceEvidence& evidence) {
  if (auto points = points_of(evidence)) return *std::move(points);
  const CommonPoint common = common_point(std::get<CommonVertices>(evidence), a.core, b.core);
  return {PointOf{common.at, common.of_a}, PointOf{common.at, common.of_b}};
}

RoundDistance distance_searched(const PlacedRound& a, const PlacedRound& b) {
  RoundDistance found;
  const RoundAnswer answer = round_round(a, b);
  StageTally tally;
  bool is_finished = answer.decided_by == DecidedBy::finishing;
  if (answer.meet()) {
    found.evidence = ExactCommonPoint{std::make_shared<const CommonPoint>(common_point_of(a, b, answer.evidence))};
  } else if (const auto cores = distance_of_cores(a, b)) {
    found.evidence = HullsApart{*closest_of(*cores), a.radius(), b.radius()};
    found.cost = cores->cost;
    is_finished = is_finished || cores->decided_by == DecidedBy::finishing;
  } else {
    found.evidence = DistanceSearch(a, b, found.cost, tally).decide(answer);
  }
  found.cost.probes += answer.cost.probes;
  found.cost.iterations += answer.cost.iterations;
  conclude(found, found.cost.exact + answer.cost.exact + tally.exact, is_finished);
  return found;
}

RoundDistance round_distance(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b) {
  return round_distance(PlacedRound(a, pose_a), PlacedRound(b, pose_b));
}

void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const RoundDistance& distance) {
  const Interval bounds = distance_of(distance);
  const auto* curved = std::get_if<CurvedApart>(&distance.evidence);
  const auto hulls = hulls_of(distance.evidence);
  if (bounds.low > 0 && (curved != nullptr || hulls)) {
    const Vector3<Dyadic> d = (curved != nullptr ? curved->nearest->direction : hulls->direction()).exact();
    pairs.add_clearance(index_a, index_b, bounds.low, {d.x, d.y, d.z});
  }
  auto found = points_of(distance.evidence);
  if (!found) {
    const CommonPoint common = pairs.common_point(index_a, index_b, std::get<CommonVertices>(distance.evidence));
    found = {PointOf{common.at, common.of_a}, PointOf{common.at, common.of_b}};
  }
  const auto& [of_a, of_b] = *found;
  const NearPoints points(of_a, of_b);
  for (double least = bounds.high; std::isfinite(least); least = std::nextafter(least, infinity)) {
    if (least == 0 || !points.nearer_than(least)) continue;
    return pairs.add_clearance_broken(index_a, index_b, least, of_a, of_b);
  }
}

void add_distance(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, const RoundDistanceEvidence& found) {
  if (verdict_of(found) == Verdict::meet) return;
  const auto [of_a, of_b] = *points_of(found);
  if (std::holds_alternative<ClosestFeatures>(found)) return pairs.add_distance(index_a, index_b, of_a, of_b);
  const double above = std::nextafter(distance_of(found).high, infinity);
  if (std::isfinite(above)) pairs.add_clearance_broken(index_a, index_b, above, of_a, of_b);
}

}  // namespace sunder::solid
