#include <sunder/base/contract.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/pair/hyperplanes.h>
#include <sunder/polytope/pair/phase_one_internal.h>
#include <sunder/polytope/pair/placed.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace sunder::polytope {

namespace {

using Around = HyperplaneEvidence::Around;

bool is_zero(const ExactVector& v) {
  return std::all_of(v.begin(), v.end(), [](const Dyadic& x) { return x.sign() == Sign::zero; });
}

// Half-spaces around a body, in its frame and in the world.
class Enclosure {
 public:
  Enclosure(std::uint32_t kind, const HierarchicalTree& tree, const Pose& pose)
      : kind_(kind), d_(tree.body().dimension()), tree_(tree), pose_(pose), walk_(tree) {
    while (walk_.deepen()) continue;
    ExactInverse inverse = *exact_inverse(d_, pose.linear());
    inverse_ = std::move(inverse.numbers);
    scale_ = std::move(inverse.denominator);
  }

  bool is_of_points() const { return tree_.body().is_of_points(); }

  // Of points, those of the shell-simplices along the path of the direction of the world; of half-spaces, those named.
  void add_first(const ExactVector& direction, const Weights& named) {
    if (!is_of_points()) {
      for (const Weights::Part& part : named.parts) {
        const std::span<const double> row = tree_.body().row(part.index);
        add({row.begin(), row.end()}, part.index);
      }
      return;
    }
    const ExactVector pulled_back = pulled(pose_, direction);
    if (is_zero(pulled_back)) return;
    Cost cost;
    walk_.furthest(pulled_back, cost);
    const std::vector<std::uint32_t> path(walk_.path().begin(), walk_.path().end());
    for (const std::uint32_t cone : path) {
      for (std::size_t k = 0; k < tree_.dimension(); ++k) add_around(unflattened(tree_.ray(cone, k)));
    }
  }

  // Of points, that of the direction itself.
  void add_last(const ExactVector& direction) {
    const ExactVector pulled_back = pulled(pose_, direction);
    if (!is_of_points() || is_zero(pulled_back)) return;
    add_around(pulled_back);
    are_shells_ = false;
  }

  // Those not tried yet. Does one pay?
  bool enter_all(PhaseOne& program) const {
    bool pays = false;
    for (std::uint32_t k = 0; k < placed_.size() && !program.is_solved(); ++k) {
      ExactVector column = placed_[k];
      column[d_] = -column[d_];
      pays = program.enter_if_it_pays({kind_, k}, column) || pays;
    }
    return pays;
  }

  // The planes, and their multipliers. The sum of the normals times these, in the world, is added.
  Around around(const PhaseOne& program, ExactVector& sum) const {
    Around result{.are_shells = are_shells_};
    if (is_of_points()) result.planes = rows_;
    for (const auto& [variable, weight] : program.weights()) {
      if (variable.kind != kind_) continue;
      result.multipliers.parts.push_back({names_[variable.index], weight * scale_});
      add_multiple(sum, weight, placed_[variable.index]);
    }
    return result;
  }

 private:
  ExactVector unflattened(std::span<const double> ray) const {
    if (!tree_.is_flat()) return {ray.begin(), ray.end()};
    ExactVector direction(d_);
    const std::vector<std::size_t> columns = tree_.columns();
    for (std::size_t k = 0; k < columns.size(); ++k) direction[columns[k]] = Dyadic(ray[k]);
    return direction;
  }

  void add_around(ExactVector normal) {
    Cost cost;
    ExactVector row = std::move(normal);
    row.push_back(walk_.furthest(row, cost).product);
    if (std::find(rows_.begin(), rows_.end(), row) == rows_.end()) {
      const auto name = static_cast<std::uint32_t>(rows_.size());
      add(std::move(row), name);
    }
  }

  // As Placed::half_space: a . x <= b for x = N (y - t) / s is (a N) . y <= s b + (a N) . t.
  void add(ExactVector row, std::uint32_t name) {
    ExactVector placed(d_ + 1);
    for (std::size_t c = 0; c < d_; ++c) {
      for (std::size_t r = 0; r < d_; ++r) placed[c] = placed[c] + row[r] * inverse_[r * d_ + c];
    }
    placed[d_] = scale_ * row[d_] + dot(placed, pose_.translation());
    placed_.push_back(std::move(placed));
    rows_.push_back(std::move(row));
    names_.push_back(name);
  }

  std::uint32_t kind_;
  std::size_t d_;
  const HierarchicalTree& tree_;
  const Pose& pose_;
  TreeWalk walk_;
  ExactVector inverse_;
  Dyadic scale_{1.0};
  std::vector<ExactVector> rows_, placed_;
  std::vector<std::uint32_t> names_;  // in the evidence
  bool are_shells_ = true;
};

// A bound of the body along the direction, by its multipliers; nothing where none is proved.
std::optional<ExactFraction> bound_along(const Polytope& body, const Pose& pose, const ExactVector& direction,
                                         const Around& around) {
  const std::size_t d = body.dimension();
  if (!body.is_of_points() && !around.planes.empty()) return std::nullopt;
  for (const ExactVector& plane : around.planes) {
    if (plane.size() != d + 1) return std::nullopt;
    for (std::uint32_t k = 0; k < body.size(); ++k) {
      if ((dot(plane, body.row(k)) - plane[d]).sign() == Sign::positive) return std::nullopt;
    }
  }
  const auto plane = [&](std::uint32_t k) { return std::span<const Dyadic>(around.planes[k]); };
  const auto row = [&](std::uint32_t k) { return body.row(k); };
  return body.is_of_points() ? bound_along(pose, direction, around.multipliers, plane, around.planes.size())
                             : bound_along(pose, direction, around.multipliers, row, body.size());
}

}  // namespace

HyperplaneEvidence parting_hyperplanes(const HierarchicalTree& a, const Pose& pose_a, const HierarchicalTree& b,
                                       const Pose& pose_b, const PolytopeAnswer& answer) {
  const ExactEvidence exact = exact_evidence(a.body(), pose_a, b.body(), pose_b, answer);
  const std::size_t d = a.body().dimension();
  const ExactVector opposite = negated(exact.numbers);
  Enclosure around_a(0, a, pose_a), around_b(1, b, pose_b);
  around_a.add_first(exact.numbers, exact.of_a);
  around_b.add_first(opposite, exact.of_b);
  PhaseOne program(d + 1, 1);  // multipliers that contradict, as of half-spaces
  const auto solve = [&] {
    for (bool pays = true; pays && !program.is_solved();) {
      const bool a_pays = around_a.enter_all(program), b_pays = around_b.enter_all(program);
      pays = a_pays || b_pays;
    }
    return program.is_solved();
  };
  if (!solve()) {
    around_a.add_last(exact.numbers);
    around_b.add_last(opposite);
    [[maybe_unused]] const bool is_solved = solve();
    SUNDER_REQUIRE(is_solved);
  }
  HyperplaneEvidence result{.direction = ExactVector(d)};
  ExactVector of_b(d);
  result.a = around_a.around(program, result.direction);
  result.b = around_b.around(program, of_b);
  return result;
}

bool check(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b,
           const HyperplaneEvidence& evidence) {
  if (evidence.direction.size() != a.dimension()) return false;
  const auto of_a = bound_along(a, pose_a, evidence.direction, evidence.a);
  const auto of_b = bound_along(b, pose_b, negated(evidence.direction), evidence.b);
  return of_a && of_b && *of_a < ExactFraction{-of_b->numerator, of_b->denominator};
}

}  // namespace sunder::polytope
