#include <sunder/base/contract.h>
#include <sunder/number/root.h>
#include <sunder/number/vector.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_nearest.h>
#include <sunder/solid/round/round_placed.h>
#include <sunder/solid/round/round_round.h>

#include <cmath>
#include <utility>

namespace sunder::solid {

namespace {

class ClearanceSearch {
 public:
  // proves: with points, where it is broken; else the answer is good for its verdict.
  ClearanceSearch(const PlacedRound& a, const PlacedRound& b, double least, bool proves, RoundClearance& found,
                  StageTally& tally)
      : a_(a), b_(b), least_(least), proves_(proves), found_(found), tally_(tally) {}

  // True: the evidence is filled in.
  template <class Real>
  bool run(const VectorOf<Real>& first) {
    RoundSearch<Real> search(a_, b_);
    if (search_nearest(search, first, *this, found_.cost)) return true;
    last_direction = rounded(search.direction);
    return keeps(search) || breaks(search);
  }

  template <class Real>
  bool parts(const RoundSearch<Real>& search, const DifferenceVertexOf<Real>& w) {
    const RoundSupport<Real>& support = search.support;
    near_a_ = support.slots[w.a].vertex_a;
    near_b_ = support.slots[w.a].vertex_b;
    return support.exceeds(search.gap_at(w), reach_of(search), search.direction) && keeps(search);
  }
  template <class Real>
  bool nears(const RoundSearch<Real>& search) {
    const Real far = reach_of(search);
    return search.distance2 * Real(1 + 16 * search.support.relative_noise) < far * far && breaks(search);
  }

  bool keeps(const WorldDirection& direction) {
    ++found_.cost.proposals;
    const RoundGap gap(a_, b_, direction, near_a_, near_b_, found_.cost, tally_);
    if (gap.against(least_) == Sign::negative) return false;
    found_.evidence = ClearanceKept{direction};
    return true;
  }
  bool breaks(NearPoints points) {
    ++found_.cost.proposals;
    ++tally_.exact;
    if (!points.nearer_than(least_)) return false;
    found_.evidence = ClearanceBroken{
        std::make_shared<const std::array<PointOf, 2>>(std::array{std::move(points.of_a), std::move(points.of_b)})};
    return true;
  }

  // Two hulls: the distance of the cores against the sum of the radii and `least`. Nothing where they meet.
  bool decide(const PolyhedronDistance& cores) {
    found_.cost.exact += cores.cost.exact;
    const ClosestFeatures* closest = closest_of(cores);
    if (closest == nullptr) return false;
    const ExactFraction square = closest->squared();
    const ClosestPoints points = closest_points(*closest);
    const Dyadic radii = Dyadic(a_.radius()) + Dyadic(b_.radius()), all = radii + Dyadic(least_);
    if (compare_root(square, all) != Sign::negative) {
      const std::array<Dyadic, 3> way = way_between(points.of_a, points.of_b);
      return keeps(WorldDirection(Vector3<Dyadic>{way[0], way[1], way[2]}));
    }
    if (compare_root(square, radii) != Sign::positive) return false;
    return breaks(points_nearer_than(least_, points, a_.radius(), b_.radius()));
  }

  Point3 last_direction{};

 private:
  template <class Real>
  Real reach_of(const RoundSearch<Real>& search) const {
    return search.support.reach + Real(least_ * search.simplex.scale);
  }
  template <class Real>
  bool keeps(const RoundSearch<Real>& search) {
    const auto& d = search.direction;
    Point3 direction = rounded(d);
    if (!make_tame(direction)) return false;
    if (keeps(WorldDirection(direction))) return true;
    if constexpr (std::is_same_v<Real, double>) return false;
    return keeps(WorldDirection(Vector3<Dyadic>{exact(d.x), exact(d.y), exact(d.z)}));
  }
  template <class Real>
  bool breaks(const RoundSearch<Real>& search) {
    if (!proves_) {
      const auto places = near_places(search, a_, b_, tally_);
      if (places && nearness_within(places->of_a, a_.body.rounding(), places->of_b, b_.body.rounding(), least_,
                                    &tally_) == Sign::positive) {
        found_.evidence = ClearanceBroken{};
        return true;
      }
    }
    auto points = near_points(search, a_, b_);
    return points && breaks(std::move(*points));
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
  double least_;
  bool proves_;
  RoundClearance& found_;
  StageTally& tally_;
  std::uint32_t near_a_ = 0, near_b_ = 0;
};

RoundClearance decided(const PlacedRound& a, const PlacedRound& b, double least, bool proves) {
  SUNDER_REQUIRE(least > 0 && std::isfinite(least));
  RoundClearance found;
  StageTally tally;
  ClearanceSearch search(a, b, least, proves, found, tally);
  bool is_finished = false;
  const auto decide = [&] {
    if (search.run<double>({})) return;
    if (const auto cores = distance_of_cores(a, b)) {
      is_finished = true;
      if (search.decide(*cores)) return;
    } else {
      const Point3& d = search.last_direction;
      const bool is_some = std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z);
      if (search.run<DoubleDouble>(is_some ? Vector3<DoubleDouble>{d.x, d.y, d.z} : Vector3<DoubleDouble>{})) return;
    }
    is_finished = true;
    const RoundAnswer answer = round_round(a, b);
    found.cost.exact += answer.cost.exact;
    if (answer.meet()) {
      const CommonPoint common = common_point_of(a, b, answer.evidence);
      const PointOf of_a{common.at, common.of_a};
      const PointOf of_b{common.at, common.of_b};
      if (search.breaks(NearPoints(of_a, of_b))) return;
    }
    for (const WorldDirection& d : simple_directions(a, b, search.last_direction)) {
      if (search.keeps(d)) return;
    }
    // What encloses the distance most tightly, whatever is asked about it.
    const RoundDistance enclosed = round_distance(a, b);
    found.cost.exact += enclosed.cost.exact;
    if (const auto* apart = std::get_if<CurvedApart>(&enclosed.evidence)) {
      if (apart->distance.low >= least && search.keeps(apart->nearest->direction)) return;
    }
    const auto [of_p, of_q] = nearest_of(a, b, enclosed.evidence);
    search.breaks(NearPoints(of_p, of_q));
  };
  decide();
  conclude(found, found.cost.exact + tally.exact, is_finished);
  return found;
}

}  // namespace

RoundClearance round_clearance(const PlacedRound& a, const PlacedRound& b, double least) {
  return decided(a, b, least, true);
}

Verdict clearance_verdict(const PlacedRound& a, const PlacedRound& b, double least) {
  return decided(a, b, least, false).verdict();
}

RoundClearance round_clearance(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                               double least) {
  return round_clearance(PlacedRound(a, pose_a), PlacedRound(b, pose_b), least);
}

void add_claims(PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b, double least,
                const RoundClearance& clearance) {
  SUNDER_REQUIRE(!clearance.undecided());
  if (const auto* kept = std::get_if<ClearanceKept>(&clearance.evidence)) {
    const Vector3<Dyadic> d = kept->direction.exact();
    return pairs.add_clearance(index_a, index_b, least, {d.x, d.y, d.z});
  }
  const auto& [of_a, of_b] = *std::get<ClearanceBroken>(clearance.evidence).points;
  pairs.add_clearance_broken(index_a, index_b, least, of_a, of_b);
}

}  // namespace sunder::solid
