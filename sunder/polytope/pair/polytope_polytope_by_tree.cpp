#include <sunder/base/contract.h>
#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <utility>

namespace sunder::polytope {

PolytopeAnswer polytope_polytope_by_tree(const HierarchicalTree& a, const Pose& pose_a, const HierarchicalTree& b,
                                         const Pose& pose_b) {
  SUNDER_REQUIRE(a.body().dimension() == b.body().dimension());
  SUNDER_REQUIRE(pose_a.dimension() == a.body().dimension());
  SUNDER_REQUIRE(pose_b.dimension() == a.body().dimension());
  PolytopeAnswer answer;
  std::uint32_t scans = 0;
  ExactDecision decision = decide_exactly({a, pose_a}, {b, pose_b}, {}, {}, answer.cost, &scans);
  answer.evidence = {.verdict = decision.verdict, .exact = std::move(decision.evidence)};
  answer.decided_by = scans == 0 ? DecidedBy::evidence : DecidedBy::finishing;
  return answer;
}

}  // namespace sunder::polytope
