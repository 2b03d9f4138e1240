#include <sunder/base/contract.h>
#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/nearest_search.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/pair/support.h>
#include <sunder/predicate/simplex_origin.h>

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
    if (!search()) finish();
    return std::move(answer_);
  }

 private:
  // True where a proposal held.
  bool search() {
    Vector direction{};
    if (!direction_from(difference(0, 0).at, d_, direction)) direction[0] = 1;
    for (int step = 0; step < most_steps; ++step) {
      const Support of_a = support(a_, pose_a_, direction, 1), of_b = support(b_, pose_b_, direction, -1);
      answer_.cost.probes += std::uint64_t{a_.size()} + b_.size();
      ++answer_.cost.iterations;
      if (of_a.product.product < of_b.product.product && parts(direction, of_a, of_b)) return true;
      if (simplex_.has(of_a.index, of_b.index)) return false;
      if (!simplex_.add(difference(of_a.index, of_b.index))) return false;
      if (simplex_.is_full()) return holds_origin();
      if (!direction_from(simplex_.nearest(), d_, direction)) return false;
    }
    return false;
  }

  DifferencePoint difference(std::uint32_t i, std::uint32_t j) const {
    DifferencePoint point{i, j, rounded_image(a_, pose_a_, i)};
    const Vector of_b = rounded_image(b_, pose_b_, j);
    for (std::size_t c = 0; c < d_; ++c) point.at[c] -= of_b[c];
    return point;
  }

  // Is all of A less far along the direction than all of B?
  bool parts(const Vector& direction, const Support& of_a, const Support& of_b) {
    ++answer_.cost.proposals;
    const Guess guess = compare(of_a.product, of_b.product);
    bool holds = guess == Guess::positive;
    if (!is_sure(guess)) {
      const ExactVector exact(direction.begin(), direction.begin() + static_cast<std::ptrdiff_t>(d_));
      ExactVector opposite;
      for (const Dyadic& x : exact) opposite.push_back(-x);
      const Dyadic last = Placed(a_, pose_a_).furthest(exact, answer_.cost).product;
      const Dyadic first = -Placed(b_, pose_b_).furthest(opposite, answer_.cost).product;
      holds = (first - last).sign() == Sign::positive;
      answer_.decided_by = DecidedBy::evidence;
    }
    if (!holds) return false;
    answer_.evidence.verdict = Verdict::apart;
    std::copy(direction.begin(), direction.end(), answer_.evidence.direction.begin());
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
    Evidence& evidence = answer_.evidence;
    evidence.verdict = Verdict::meet;
    collect(evidence);
    return true;
  }

  // The points of the simplex, each once.
  void collect(Evidence& evidence) const {
    const auto add = [](std::uint32_t k, auto& list, std::uint8_t& count) {
      const auto end = list.begin() + count;
      if (std::find(list.begin(), end, k) == end) list[count++] = k;
    };
    for (std::size_t k = 0; k < simplex_.size(); ++k) {
      add(simplex_[k].a, evidence.of_a, evidence.count_a);
      add(simplex_[k].b, evidence.of_b, evidence.count_b);
    }
  }

  void finish() {
    Evidence hint;
    collect(hint);
    ExactDecision decision = decide_exactly({a_, pose_a_}, {b_, pose_b_}, std::span(hint.of_a).first(hint.count_a),
                                            std::span(hint.of_b).first(hint.count_b), answer_.cost);
    answer_.evidence = {.verdict = decision.verdict, .exact = std::move(decision.evidence)};
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
  ExactDecision decision = decide_exactly({a, pose_a}, {b, pose_b}, {}, {}, answer.cost);
  answer.evidence = {.verdict = decision.verdict, .exact = std::move(decision.evidence)};
  answer.decided_by = DecidedBy::finishing;
  return answer;
}

PolytopeAnswer polytope_polytope(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b) {
  return polytope_polytope_by_gjk(a, pose_a, b, pose_b);
}

ExactEvidence exact_evidence(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b,
                             const PolytopeAnswer& answer) {
  require_one_dimension(a, pose_a, b, pose_b);
  const Evidence& evidence = answer.evidence;
  if (evidence.exact) return *evidence.exact;
  if (evidence.verdict == Verdict::meet) {
    return common_point_of({a, pose_a}, {b, pose_b}, std::span(evidence.of_a).first(evidence.count_a),
                           std::span(evidence.of_b).first(evidence.count_b));
  }
  const auto begin = evidence.direction.begin();
  return {.numbers = ExactVector(begin, begin + static_cast<std::ptrdiff_t>(a.dimension()))};
}

}  // namespace sunder::polytope
