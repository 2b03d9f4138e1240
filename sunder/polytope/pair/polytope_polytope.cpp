#include <sunder/base/contract.h>
#include <sunder/polytope/pair/candidate_rows.h>
#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/facet_normal.h>
#include <sunder/polytope/pair/half_space_search.h>
#include <sunder/polytope/pair/points_search_internal.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <memory>
#include <span>
#include <utility>

namespace sunder::polytope {

namespace {

// By scans: first among samples of the points, then among shortlists.
class ScannedEnds {
 public:
  ScannedEnds(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b)
      : a_(a, pose_a), b_(b, pose_b), candidates_(a, b) {}

  CandidateRowsOfBoth& candidates() { return candidates_; }
  BothEnds along(const Vector& direction, Cost& cost) {
    return {likely_support(candidates_.a, a_.pose(), direction, 1, cost),
            likely_support(candidates_.b, b_.pose(), direction, -1, cost)};
  }
  static bool are_ends(const Vector&, const Cost&) { return true; }
  ExactFurthest exact_a(const ExactVector& y, Cost& cost) { return a_.furthest(y, cost); }
  ExactFurthest exact_b(const ExactVector& y, Cost& cost) { return b_.furthest(y, cost); }

  Placed& a() { return a_; }
  Placed& b() { return b_; }

 private:
  Placed a_, b_;
  CandidateRowsOfBoth candidates_;
};

// Does the exact normal of a facet near the origin part the bodies?
std::shared_ptr<const ExactEvidence> parting_normal(ScannedEnds& ends, const NearestSimplex& simplex, Cost& cost) {
  if (simplex.size() == 0) return nullptr;
  auto y = facet_normal(ends.a(), ends.b(), simplex, cost);
  if (!y) return nullptr;
  ++cost.proposals;
  const Dyadic last = ends.exact_a(*y, cost).product, first = -ends.exact_b(negated(*y), cost).product;
  if ((first - last).sign() != Sign::positive) return nullptr;
  return std::make_shared<const ExactEvidence>(ExactEvidence{.numbers = *std::move(y)});
}

PolytopeAnswer points_by_gjk(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b) {
  PolytopeAnswer answer;
  ScannedEnds ends(a, pose_a, b, pose_b);
  PointsSearch search(a, pose_a, b, pose_b, ends, answer.cost);
  if (search.search()) {
    answer.evidence = search.evidence();
    answer.decided_by = search.decided_by();
  } else if (auto normal = parting_normal(ends, search.simplex(), answer.cost)) {
    answer.evidence = ExactParting{std::move(normal)};
    answer.decided_by = DecidedBy::evidence;
  } else {
    const CommonPoints named = search.collected();
    ExactDecision decision = decide_exactly({a, pose_a}, {b, pose_b}, std::span(named.of_a).first(named.count_a),
                                            std::span(named.of_b).first(named.count_b), answer.cost);
    answer.evidence = evidence_of(decision.verdict, std::move(decision.evidence));
    answer.decided_by = DecidedBy::finishing;
  }
  return answer;
}

void require_one_dimension([[maybe_unused]] const Polytope& a, [[maybe_unused]] const Pose& pose_a,
                           [[maybe_unused]] const Polytope& b, [[maybe_unused]] const Pose& pose_b) {
  SUNDER_REQUIRE(a.dimension() == b.dimension());
  SUNDER_REQUIRE(pose_a.dimension() == a.dimension());
  SUNDER_REQUIRE(pose_b.dimension() == a.dimension());
}

}  // namespace

PolytopeAnswer polytope_polytope_by_gjk(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b) {
  require_one_dimension(a, pose_a, b, pose_b);
  if (a.is_of_points() && b.is_of_points()) return points_by_gjk(a, pose_a, b, pose_b);
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
