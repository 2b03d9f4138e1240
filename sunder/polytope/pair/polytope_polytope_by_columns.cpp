#include <sunder/base/contract.h>
#include <sunder/polytope/pair/exact_simplex.h>
#include <sunder/polytope/pair/nearest_search.h>
#include <sunder/polytope/pair/placed.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/pair/support.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

constexpr int most_column_steps = 64;

// The search of by_gjk, with walks to the leaves for scans. What a walk finds is the end of its body, exactly: so two
// of them tell whether their direction parts the bodies.
class ColumnSearch {
 public:
  ColumnSearch(const HierarchicalTree& a, const Pose& pose_a, const HierarchicalTree& b, const Pose& pose_b)
      : a_(a, pose_a), b_(b, pose_b), d_(pose_a.dimension()), simplex_(d_) {
    for (Placed* const body : {&a_, &b_}) {
      while (body->deepen()) continue;
    }
  }

  // True where a direction parts the bodies: it is written down. Else they may meet.
  bool parts(PolytopeAnswer& answer) {
    bool are_apart = false;
    simplex_.search(
        difference(0, 0).at, most_column_steps, nullptr, [&](const Vector& direction, DifferencePoint& next) {
          ExactVector along(direction.begin(), direction.begin() + static_cast<std::ptrdiff_t>(d_));
          const ExactFurthest of_a = a_.furthest(along, answer.cost), of_b = b_.furthest(negated(along), answer.cost);
          ++answer.cost.iterations;
          ++answer.cost.proposals;
          are_apart = (of_a.product + of_b.product).sign() == Sign::negative;
          if (are_apart) {
            answer.evidence =
                ExactParting{std::make_shared<const ExactEvidence>(ExactEvidence{.numbers = std::move(along)})};
            return NearestStep::stop;
          }
          next = difference(of_a.index, of_b.index);
          return NearestStep::take;
        });
    return are_apart;
  }

  // The points of the simplex, of A or of B, each once.
  std::vector<std::uint32_t> named(std::uint32_t DifferencePoint::* of) const {
    std::vector<std::uint32_t> rows;
    for (std::size_t k = 0; k < simplex_.size(); ++k) {
      if (std::find(rows.begin(), rows.end(), simplex_[k].*of) == rows.end()) rows.push_back(simplex_[k].*of);
    }
    return rows;
  }

  std::uint32_t scans() const { return a_.scans() + b_.scans(); }

 private:
  DifferencePoint difference(std::uint32_t i, std::uint32_t j) const {
    return rounded_difference(a_.body(), a_.pose(), i, b_.body(), b_.pose(), j);
  }

  Placed a_, b_;
  std::size_t d_;
  NearestSimplex simplex_;
};

}  // namespace

PolytopeAnswer polytope_polytope_by_columns(const HierarchicalTree& a, const Pose& pose_a, const HierarchicalTree& b,
                                            const Pose& pose_b) {
  SUNDER_REQUIRE(a.body().dimension() == b.body().dimension());
  SUNDER_REQUIRE(pose_a.dimension() == a.body().dimension());
  SUNDER_REQUIRE(pose_b.dimension() == a.body().dimension());
  PolytopeAnswer answer;
  std::uint32_t scans = 0;
  std::vector<std::uint32_t> of_a, of_b;
  if (a.body().is_of_points() && b.body().is_of_points()) {
    ColumnSearch search(a, pose_a, b, pose_b);
    const bool are_apart = search.parts(answer);
    scans = search.scans();
    answer.decided_by = scans == 0 ? DecidedBy::evidence : DecidedBy::finishing;
    if (are_apart) return answer;
    of_a = search.named(&DifferencePoint::a);
    of_b = search.named(&DifferencePoint::b);
  }
  ExactDecision decision = decide_exactly({a, pose_a}, {b, pose_b}, of_a, of_b, answer.cost, &scans);
  answer.evidence = evidence_of(decision.verdict, std::move(decision.evidence));
  answer.decided_by = scans == 0 ? DecidedBy::evidence : DecidedBy::finishing;
  return answer;
}

}  // namespace sunder::polytope
