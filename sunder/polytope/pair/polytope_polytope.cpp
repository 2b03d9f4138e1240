#include <sunder/base/contract.h>
#include <sunder/polytope/pair/common_weights.h>
#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/facet_normal.h>
#include <sunder/polytope/pair/half_space_search.h>
#include <sunder/polytope/pair/nearest_search.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/pair/support.h>
#include <sunder/predicate/point/simplex_origin.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace sunder::polytope {

namespace {

constexpr int most_steps = 64;  // of the search; it takes some 2 d to 4 d

class Search {
 public:
  Search(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b)
      : a_(a), b_(b), pose_a_(pose_a), pose_b_(pose_b), d_(a.dimension()), simplex_(d_) {}

  PolytopeAnswer answer() {
    if (!search() && !holds_origin_exactly() && !normal_parts()) finish();
    return std::move(answer_);
  }

 private:
  // True where a proposal held. First among samples of the points, then among shortlists: whatever their simplex is, it
  // goes on with all.
  bool search() {
    CandidateRowsOfBoth candidates(a_, b_);
    bool are_apart = false;
    simplex_.search(difference(0, 0).at, most_steps, &candidates, [&](const Vector& direction, DifferencePoint& next) {
      if (simplex_.is_at_origin()) return NearestStep::stop;
      const FurthestPoint of_a = likely_support(candidates.a, pose_a_, direction, 1, answer_.cost),
                          of_b = likely_support(candidates.b, pose_b_, direction, -1, answer_.cost);
      ++answer_.cost.iterations;
      if (of_a.product < of_b.product) {
        are_apart = candidates.are_all() && parts(direction, of_a.product, of_b.product);
        if (are_apart) return NearestStep::stop;
        if (candidates.widen()) return NearestStep::again;
      }
      next = difference(of_a.index, of_b.index);
      return NearestStep::take;
    });
    return are_apart || (simplex_.is_full() && holds_origin());
  }

  DifferencePoint difference(std::uint32_t i, std::uint32_t j) const {
    return rounded_difference(a_, pose_a_, i, b_, pose_b_, j);
  }

  // Is all of A less far along the direction than all of B?
  bool parts(const Vector& direction, double of_a, double of_b) {
    ++answer_.cost.proposals;
    const Guess guess = compare(BoundedProduct{of_a, support_error(a_, pose_a_, direction)},
                                BoundedProduct{of_b, support_error(b_, pose_b_, direction)});
    bool holds = guess == Guess::positive;
    if (!is_sure(guess)) {
      const ExactVector exact(direction.begin(), direction.begin() + static_cast<std::ptrdiff_t>(d_));
      const Dyadic last = Placed(a_, pose_a_).furthest(exact, answer_.cost).product;
      const Dyadic first = -Placed(b_, pose_b_).furthest(negated(exact), answer_.cost).product;
      holds = (first - last).sign() == Sign::positive;
      answer_.decided_by = DecidedBy::evidence;
    }
    if (!holds) return false;
    std::copy_n(direction.begin(), d_, answer_.evidence.emplace<PartingDirection>().direction.begin());
    return true;
  }

  // Does the simplex hold the origin, surely?
  bool holds_origin() {
    ++answer_.cost.proposals;
    std::array<Interval, most_dimension*(most_dimension + 1)> points;
    for (std::size_t k = 0; k < simplex_.size(); ++k) {
      const std::array<Interval, most_dimension> of_a = enclosed_image(a_, pose_a_, simplex_[k].a);
      const std::array<Interval, most_dimension> of_b = enclosed_image(b_, pose_b_, simplex_[k].b);
      for (std::size_t r = 0; r < d_; ++r) points[k * d_ + r] = of_a[r] - of_b[r];
    }
    if (least_weight_of_origin(std::span<const Interval>(points).first(d_ * (d_ + 1)), d_) != Guess::positive) {
      return false;
    }
    answer_.evidence = collected();
    return true;
  }

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

  // Does the simplex, which may be of any dimension, hold the origin, by exact weights?
  bool holds_origin_exactly() {
    if (simplex_.size() == 0) return false;
    ++answer_.cost.exact;
    const CommonPoints points = collected();
    auto common = common_point_by_determinants(
        a_, pose_a_, b_, pose_b_,
        {std::span(points.of_a).first(points.count_a), std::span(points.of_b).first(points.count_b)});
    if (!common) return false;
    answer_.evidence = ExactMeeting{std::make_shared<const ExactEvidence>(*std::move(common))};
    answer_.decided_by = DecidedBy::evidence;
    return true;
  }

  // Does the exact normal of a facet near the origin part the bodies?
  bool normal_parts() {
    if (simplex_.size() == 0) return false;
    Placed a(a_, pose_a_), b(b_, pose_b_);
    auto y = facet_normal(a, b, simplex_, answer_.cost);
    if (!y) return false;
    ++answer_.cost.proposals;
    const Dyadic last = a.furthest(*y, answer_.cost).product, least = -b.furthest(negated(*y), answer_.cost).product;
    if ((least - last).sign() != Sign::positive) return false;
    answer_.evidence = ExactParting{std::make_shared<const ExactEvidence>(ExactEvidence{.numbers = *std::move(y)})};
    answer_.decided_by = DecidedBy::evidence;
    return true;
  }

  void finish() {
    const CommonPoints hint = collected();
    ExactDecision decision = decide_exactly({a_, pose_a_}, {b_, pose_b_}, std::span(hint.of_a).first(hint.count_a),
                                            std::span(hint.of_b).first(hint.count_b), answer_.cost);
    answer_.evidence = evidence_of(decision.verdict, std::move(decision.evidence));
    answer_.decided_by = DecidedBy::finishing;
  }

  const Polytope &a_, &b_;
  const Pose &pose_a_, &pose_b_;
  std::size_t d_;
  NearestSimplex simplex_;
  PolytopeAnswer answer_;
};

void require_one_dimension([[maybe_unused]] const Polytope& a, [[maybe_unused]] const Pose& pose_a,
                           [[maybe_unused]] const Polytope& b, [[maybe_unused]] const Pose& pose_b) {
  SUNDER_REQUIRE(a.dimension() == b.dimension());
  SUNDER_REQUIRE(pose_a.dimension() == a.dimension());
  SUNDER_REQUIRE(pose_b.dimension() == a.dimension());
}

}  // namespace

PolytopeAnswer polytope_polytope_by_gjk(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b) {
  require_one_dimension(a, pose_a, b, pose_b);
  if (a.is_of_points() && b.is_of_points()) return Search(a, pose_a, b, pose_b).answer();
  PolytopeAnswer answer;
  HalfSpaceProposal proposal = search_half_spaces(a, pose_a, b, pose_b, answer.cost);
  answer.decided_by = proposal.decision ? DecidedBy::evidence : DecidedBy::finishing;
  ExactDecision decision = proposal.decision
                               ? *std::move(proposal.decision)
                               : decide_exactly({a, pose_a}, {b, pose_b}, proposal.of_a, proposal.of_b, answer.cost);
  answer.evidence = evidence_of(decision.verdict, std::move(decision.evidence));
  return answer;
}

PolytopeAnswer polytope_polytope(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b) {
  return polytope_polytope_by_gjk(a, pose_a, b, pose_b);
}

ExactEvidence exact_evidence(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b,
                             const PolytopeAnswer& answer) {
  require_one_dimension(a, pose_a, b, pose_b);
  if (const auto exact = exact_part(answer.evidence)) return *exact;
  if (const auto* points = std::get_if<CommonPoints>(&answer.evidence)) {
    const NamedPoints named{std::span(points->of_a).first(points->count_a),
                            std::span(points->of_b).first(points->count_b)};
    if (auto common = common_point_by_determinants(a, pose_a, b, pose_b, named)) return *std::move(common);
    return common_point_of({a, pose_a}, {b, pose_b}, named.of_a, named.of_b);
  }
  const auto begin = std::get<PartingDirection>(answer.evidence).direction.begin();
  return {.numbers = ExactVector(begin, begin + static_cast<std::ptrdiff_t>(a.dimension()))};
}

}  // namespace sunder::polytope
