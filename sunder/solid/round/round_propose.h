// What a search for bodies with a radius proposes, and how it is disposed of. For the sources of solid/round.
#pragma once

#include <sunder/solid/round/round_finish.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/round/round_search.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace sunder::solid {

// Checks what is proposed. True: the evidence is filled in.
class RoundDisposal {
 public:
  // strictly: points have to be inside of bodies with a radius.
  RoundDisposal(const PlacedRound& a, const PlacedRound& b, RoundAnswer& answer, StageTally& tally,
                bool strictly = false)
      : a_(a), b_(b), answer_(answer), tally_(tally), least_(strictly ? Sign::positive : Sign::zero) {}

  // The direction parts A from B. Vertices of hulls to look from.
  bool parts(const WorldDirection& direction, std::uint32_t near_a, std::uint32_t near_b) {
    ++answer_.cost.proposals;
    const RoundShape a = shape_along(a_, direction, End::greatest, near_a, answer_.cost, tally_);
    const RoundShape b = shape_along(b_, direction, End::least, near_b, answer_.cost, tally_);
    if (gap_sign(direction, a, b, &tally_) != Sign::positive) return false;
    return is(separation_along(direction));
  }

  // Points of both cores are near enough to each other. Requires hulls.
  bool meets_between(const RoundCombination& a, const RoundCombination& b) {
    ++answer_.cost.proposals;
    if (nearness(round_detail::weighted(a_, a), a_.radius(), round_detail::weighted(b_, b), b_.radius(), &tally_) <
        least_)
      return false;
    return is(PointBetweenCores{a, b});
  }

  // Both hold the point. Combinations are of hulls.
  bool meets_at(const Point3& point, const RoundCombination& a, const RoundCombination& b) {
    if (!round_detail::is_finite(point)) return false;
    ++answer_.cost.proposals;
    const WeightedPoint x = round_detail::weighted(point);
    return side_of(a_, x, a, &tally_) >= least_ && side_of(b_, x, b, &tally_) >= least_ &&
           is(PointInDoubles{point, a, b});
  }

  // The same of a point in exact numbers.
  bool meets_at(const ExactPoint3& x, const RoundCombination& a, const RoundCombination& b) {
    ++answer_.cost.proposals;
    tally_.exact += 2;
    const Combination of_a = round_detail::exact(a), of_b = round_detail::exact(b);
    if (side_of(a_, x, of_a) < least_ || side_of(b_, x, of_b) < least_) return false;
    return is(ExactCommonPoint{
        std::make_shared<const CommonPoint>(CommonPoint{x, made_by(a_, x, of_a), made_by(b_, x, of_b)})});
  }

  // A point of one core, which the other body holds. `core_a`: of A.
  bool meets_in_core(bool core_a, const RoundCombination& c) {
    ++answer_.cost.proposals;
    const WeightedPoint x = round_detail::weighted(core_a ? a_ : b_, c);
    if (side_of((core_a ? b_ : a_).shape, x, &tally_) < least_) return false;
    return is(PointOfCore{core_a, c});
  }

 private:
  template <class Evidence>
  bool is(Evidence&& evidence) {
    answer_.evidence = std::forward<Evidence>(evidence);
    return true;
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
  RoundAnswer& answer_;
  StageTally& tally_;
  Sign least_;
};

// One search, and what it proposes.
template <class Real>
class RoundProposer {
 public:
  using Vector = VectorOf<Real>;

  RoundProposer(const PlacedRound& a, const PlacedRound& b, RoundDisposal& dispose, Cost& cost)
      : dispose_(dispose), cost_(cost), search(a, b) {}

  // As they are; and where that neither parts them nor finds a point that both hold, as curved bodies are when they
  // have shrunk a little: what is of the surface there is inside of them. Where they overlap by less than they shrink,
  // they have to shrink by less.
  bool propose(const Vector& first) {
    if (run(first)) return true;
    if (!is_near_ || !search.support.can_shrink) return false;
    const std::array<Point3, 2> found = nearest_points;
    const std::array<RoundCombination, 2> made = nearest_made;
    for (const double shrink : shrinks) {
      search.support.shrink(shrink);
      for (int again = 0; again < runs; ++again) {
        if (run(search.direction)) return true;
      }
    }
    nearest_points = found;
    nearest_made = made;
    return false;
  }

 private:
  // By which parts of their size curved bodies shrink, one after the other: by less no search sees.
  static constexpr auto shrinks = [] {
    if constexpr (std::is_same_v<Real, double>) {
      return std::array{0x1p-20};
    } else {
      return std::array{0x1p-42, 0x1p-56, 0x1p-70, 0x1p-84};
    }
  }();
  static constexpr int runs = std::is_same_v<Real, double> ? 1 : 3;  // of those that have shrunk

  bool run(const Vector& first) {
    search.begin(first);
    const RoundSupport<Real>& support = search.support;
    const auto on_vertex = [&](const DifferenceVertexOf<Real>& w) {
      near_a = support.slots[w.a].vertex_a;
      near_b = support.slots[w.a].vertex_b;
      const Real gap = search.gap_at(w);
      const double clear = nearest(gap) / std::sqrt(nearest(dot(search.direction, search.direction)));
      if (clear > best_gap_) {
        best_gap_ = clear;
        best_direction = rounded(search.direction);
      }
      return support.exceeds(gap, support.reach, search.direction) && parts();
    };
    const auto on_step = [&](bool) {
      return support.reach > Real(0) && search.distance2 < support.reach * support.reach && meets();
    };
    constexpr GjkLimits limits{round_steps<Real>, std::is_same_v<Real, double> ? 4 : 20};
    if (search.run(limits, cost_, on_vertex, on_step) == GjkEnd::stopped || parts_narrowly()) return true;
    is_near_ = true;
    return meets(true);
  }

 public:
  std::uint32_t near_a = 0, near_b = 0;
  std::array<Point3, 2> nearest_points{};          // of A and of B, about
  std::array<RoundCombination, 2> nearest_made{};  // of hulls: these of their cores
  Point3 best_direction{};                         // which parts them furthest, about

 private:
  bool parts() {
    const Vector& d = search.direction;
    Point3 direction = rounded(d);
    if (!make_tame(direction)) return false;
    if (dispose_.parts(WorldDirection(direction), near_a, near_b)) return true;
    return parts_exactly(d);
  }
  bool parts_exactly(const Point3&) { return false; }
  bool parts_exactly(const Vector3<DoubleDouble>& d) {
    const auto exact = [](const DoubleDouble& x) { return Dyadic(x.high) + Dyadic(x.low); };
    return dispose_.parts(WorldDirection(Vector3<Dyadic>{exact(d.x), exact(d.y), exact(d.z)}), near_a, near_b);
  }

  // At the end: the last direction, whatever rounding says of it.
  bool parts_narrowly() { return search.simplex.count > 0 && search.simplex.count < 4 && parts(); }

  bool meets(bool is_last = false) {
    const auto made = made_of(search);
    if (!made) return false;
    const RoundCombination &of_a = made->a, &of_b = made->b;
    const bool core_a = of_a.count() > 0, core_b = of_b.count() > 0;
    if (core_a && core_b) return dispose_.meets_between(of_a, of_b);
    if (core_a && dispose_.meets_in_core(true, of_a)) return true;
    if (core_b && dispose_.meets_in_core(false, of_b)) return true;
    const bool is_all_core = (core_a || core_b) && !(search.support.reach > Real(0));
    if (is_all_core) return false;
    // Between the points of both that are nearest: of a hull as far from the core as its radius lets it be, and half of
    // what is left over.
    const Vector way = minus(made->of_b, made->of_a);
    const Real length = round_detail::root_of(dot(way, way));
    const auto at = [&](const Vector& from, const Real& by) {
      return length > Real(0) ? round_detail::sum<Real>(from, by / length, way) : from;
    };
    const Real slack = search.support.reach - length;
    nearest_points = {search.support.in_world(made->of_a), search.support.in_world(made->of_b)};
    nearest_made = {of_a, of_b};
    for (const double part : {0.5, 0.0625, 0.0, 1.0}) {
      const Real depth = slack > Real(0) ? slack * Real(part) : Real(0);
      const Vector x = core_a   ? at(made->of_b, depth)
                       : core_b ? at(made->of_a, -depth)
                                : at(made->of_a, length * Real(part));
      if (dispose_.meets_at(search.support.in_world(x), of_a, of_b)) return true;
      if (is_last && meets_exactly(x, of_a, of_b)) return true;
    }
    return false;
  }
  // Doubles may hold no point of what is thinner than their last bit.
  bool meets_exactly(const Point3&, const RoundCombination&, const RoundCombination&) { return false; }
  bool meets_exactly(const Vector3<DoubleDouble>& x, const RoundCombination& a, const RoundCombination& b) {
    const auto in_world = search.support.exactly_in_world(x);
    return in_world && dispose_.meets_at(*in_world, a, b);
  }

  RoundDisposal& dispose_;
  Cost& cost_;
  double best_gap_ = -std::numeric_limits<double>::infinity();
  bool is_near_ = false;  // the search ended without parting them

 public:
  RoundSearch<Real> search;
};

}  // namespace sunder::solid
