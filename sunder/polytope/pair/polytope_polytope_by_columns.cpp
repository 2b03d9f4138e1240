#include <sunder/base/contract.h>
#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/points_search_internal.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <cstdint>
#include <span>
#include <utility>

namespace sunder::polytope {

namespace {

// By walks. First only to the root's net; where its ends lead no further, to the leaves; after that, as long as they
// lead further, among the rows of the last leaves, and so on.
class WalkedEnds {
  using Reach = TreeWalk::Reach;

 public:
  WalkedEnds(const HierarchicalTree& a, const Pose& pose_a, const HierarchicalTree& b, const Pose& pose_b)
      : a_(a, pose_a), b_(b, pose_b), walk_a_(a), walk_b_(b) {
    for (Placed* const body : {&a_, &b_}) {
      while (body->deepen()) continue;
    }
  }

  WalkedEnds& candidates() { return *this; }
  bool are_all() const { return reach_ == Reach::leaf; }
  bool widen() { return std::exchange(reach_, Reach::leaf) != Reach::leaf; }
  void narrow() {
    if (are_all()) reach_ = Reach::last_leaf;
  }

  BothEnds along(const Vector& direction, Cost& cost) {
    return {likely_support(walk_a_, a_.pose(), direction, 1, reach_, cost),
            likely_support(walk_b_, b_.pose(), direction, -1, reach_, cost)};
  }
  bool are_ends(const Vector& direction, Cost& cost) const {
    return is_sure(walk_a_, a_.pose(), direction, 1, cost) && is_sure(walk_b_, b_.pose(), direction, -1, cost);
  }
  ExactFurthest exact_a(const ExactVector& y, Cost& cost) { return a_.furthest(y, cost); }
  ExactFurthest exact_b(const ExactVector& y, Cost& cost) { return b_.furthest(y, cost); }

  std::uint32_t scans() const { return a_.scans() + b_.scans() + walk_a_.scans() + walk_b_.scans(); }

 private:
  Placed a_, b_;  // where floating point is not sure
  TreeWalk walk_a_, walk_b_;
  Reach reach_ = Reach::net;
};

}  // namespace

PolytopeAnswer polytope_polytope_by_columns(const HierarchicalTree& a, const Pose& pose_a, const HierarchicalTree& b,
                                            const Pose& pose_b) {
  SUNDER_REQUIRE(a.body().dimension() == b.body().dimension());
  SUNDER_REQUIRE(pose_a.dimension() == a.body().dimension());
  SUNDER_REQUIRE(pose_b.dimension() == a.body().dimension());
  PolytopeAnswer answer;
  std::uint32_t scans = 0;
  CommonPoints named;
  if (a.body().is_of_points() && b.body().is_of_points()) {
    WalkedEnds ends(a, pose_a, b, pose_b);
    PointsSearch search(a.body(), pose_a, b.body(), pose_b, ends, answer.cost);
    const bool is_decided = search.search();
    scans = ends.scans();
    answer.decided_by = scans == 0 ? search.decided_by() : DecidedBy::finishing;
    answer.evidence = search.evidence();
    if (is_decided) return answer;
    named = search.collected();
  }
  ExactDecision decision = decide_exactly({a, pose_a}, {b, pose_b}, std::span(named.of_a).first(named.count_a),
                                          std::span(named.of_b).first(named.count_b), answer.cost, &scans);
  answer.evidence = evidence_of(decision.verdict, std::move(decision.evidence));
  answer.decided_by = scans == 0 ? DecidedBy::evidence : DecidedBy::finishing;
  return answer;
}

}  // namespace sunder::polytope
