// The search of two bodies of points for a proof: the nearest point of the difference A - B to the origin is searched
// in floating point, each direction is a proposal to part the bodies, a simplex of differences one that they meet.
// Filters check these, and exact numbers where filters are not sure. What finds the ends of the bodies along a
// direction, all rows or a walk down a tree, is a parameter.
// Source: Gilbert, Johnson & Keerthi 1988; Wolfe 1976.
#pragma once

#include <sunder/polytope/pair/common_weights.h>
#include <sunder/polytope/pair/nearest_search.h>
#include <sunder/polytope/pair/placed.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/pair/support.h>
#include <sunder/predicate/point/simplex_origin.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace sunder::polytope {

// A's furthest point along a direction of the world, and B's least far, as floating point has them.
struct BothEnds {
  FurthestPoint a, b;
};

// Ends:
//   candidates()            which rows are looked at: widen(), narrow(), are_all() (candidate_rows.h)
//   along(direction, cost)  BothEnds
//   are_ends(direction, cost)   after along(direction) with all rows: is surely no row of A, and none of B, further
//                               than what was found by more than support_error()?
//   exact_a(y, cost), exact_b(y, cost)   the furthest point of all, exactly
template <class Ends>
class PointsSearch {
 public:
  PointsSearch(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b, Ends& ends, Cost& cost)
      : a_(a), b_(b), pose_a_(pose_a), pose_b_(pose_b), d_(a.dimension()), ends_(ends), cost_(cost), simplex_(d_) {}

  // True where a proposal held: evidence() and decided_by() tell which.
  bool search() {
    bool are_apart = false;
    simplex_.search(rounded_difference(a_, pose_a_, 0, b_, pose_b_, 0).at, most_steps, ends_.candidates(),
                    [&](const Vector& direction, DifferencePoint& next) {
                      if (simplex_.is_at_origin()) return NearestStep::stop;
                      const BothEnds ends = ends_.along(direction, cost_);
                      ++cost_.iterations;
                      if (ends.a.product < ends.b.product) {
                        are_apart = parts(direction, ends);
                        if (are_apart) return NearestStep::stop;
                        if (ends_.candidates().widen()) return NearestStep::again;
                      }
                      next = rounded_difference(a_, pose_a_, ends.a.index, b_, pose_b_, ends.b.index);
                      return NearestStep::take;
                    });
    return are_apart || (simplex_.is_full() && holds_origin()) || holds_origin_exactly();
  }

  const NearestSimplex& simplex() const { return simplex_; }
  const Evidence& evidence() const { return evidence_; }
  DecidedBy decided_by() const { return decided_by_; }

  // The points of the simplex, each once.
  CommonPoints collected() const {
    CommonPoints points;
    const auto add = [](std::uint32_t k, auto& list, std::uint8_t& count) {
      const auto end = list.begin() + count;
      if (std::find(list.begin(), end, k) == end) list[count++] = k;
    };
    for (std::size_t k = 0; k < simplex_.size(); ++k) {
      add(simplex_[k].a, points.of_a, points.count_a);
      add(simplex_[k].b, points.of_b, points.count_b);
    }
    return points;
  }

 private:
  static constexpr int most_steps = 64;  // it takes some 2 d to 4 d

  // Is all of A less far along the direction than all of B?
  bool parts(const Vector& direction, const BothEnds& ends) {
    if (!ends_.candidates().are_all()) return false;
    ++cost_.proposals;
    const Guess guess = ends_.are_ends(direction, cost_)
                            ? compare(BoundedProduct{ends.a.product, support_error(a_, pose_a_, direction)},
                                      BoundedProduct{ends.b.product, support_error(b_, pose_b_, direction)})
                            : Guess::unsure;
    bool holds = guess == Guess::positive;
    if (!is_sure(guess)) {
      const ExactVector exact(direction.begin(), direction.begin() + static_cast<std::ptrdiff_t>(d_));
      const Dyadic last = ends_.exact_a(exact, cost_).product, first = -ends_.exact_b(negated(exact), cost_).product;
      holds = (first - last).sign() == Sign::positive;
      decided_by_ = DecidedBy::evidence;
    }
    if (!holds) return false;
    std::copy_n(direction.begin(), d_, evidence_.emplace<PartingDirection>().direction.begin());
    return true;
  }

  // Does the simplex hold the origin, surely?
  bool holds_origin() {
    ++cost_.proposals;
    std::array<Interval, most_dimension*(most_dimension + 1)> points;
    for (std::size_t k = 0; k < simplex_.size(); ++k) {
      const std::array<Interval, most_dimension> of_a = enclosed_image(a_, pose_a_, simplex_[k].a);
      const std::array<Interval, most_dimension> of_b = enclosed_image(b_, pose_b_, simplex_[k].b);
      for (std::size_t r = 0; r < d_; ++r) points[k * d_ + r] = of_a[r] - of_b[r];
    }
    if (least_weight_of_origin(std::span<const Interval>(points).first(d_ * (d_ + 1)), d_) != Guess::positive) {
      return false;
    }
    evidence_ = collected();
    return true;
  }

  // Does the simplex, which may be of any dimension, hold the origin, by exact weights?
  bool holds_origin_exactly() {
    if (simplex_.size() == 0) return false;
    ++cost_.exact;
    const CommonPoints points = collected();
    auto common = common_point_by_determinants(
        a_, pose_a_, b_, pose_b_,
        {std::span(points.of_a).first(points.count_a), std::span(points.of_b).first(points.count_b)});
    if (!common) return false;
    evidence_ = ExactMeeting{std::make_shared<const ExactEvidence>(*std::move(common))};
    decided_by_ = DecidedBy::evidence;
    return true;
  }

  const Polytope &a_, &b_;
  const Pose &pose_a_, &pose_b_;
  std::size_t d_;
  Ends& ends_;
  Cost& cost_;
  NearestSimplex simplex_;
  Evidence evidence_;
  DecidedBy decided_by_ = DecidedBy::filter;
};

}  // namespace sunder::polytope
