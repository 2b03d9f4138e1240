#include <sunder/base/contract.h>
#include <sunder/base/names.h>
#include <sunder/planar/region/linear_program.h>

namespace sunder::planar {

std::string_view name_of(Optimum outcome) {
  return name_in<Optimum::infeasible>({"one", "many", "all", "unbounded", "infeasible"}, outcome);
}

template <class Given>
LinearProgramAnswer linear_program(const Given& given, const Objective& objective) {
  return linear_program_by_sampling(given, objective);
}

template <class Given>
ExactPoint2 point_of(const Given& given, const LinearProgramAnswer& answer) {
  SUNDER_REQUIRE(answer.outcome != Optimum::infeasible);
  const auto corner = [&](std::uint32_t i, std::uint32_t j) { return exact_corner(given[i], given[j]); };
  const bool of_side =
      answer.side != no_half_plane && (answer.outcome == Optimum::one || answer.outcome == Optimum::many);
  if (of_side) {
    if (answer.before != no_half_plane) return corner(answer.before, answer.side);
    if (answer.after != no_half_plane) return corner(answer.side, answer.after);
    return exact_point_on(given[answer.side]);
  }
  if (answer.after != no_half_plane) return corner(answer.before, answer.after);
  if (answer.before != no_half_plane) return exact_point_on(given[answer.before]);
  return {0.0, 0.0, 1.0};
}

namespace {

template <class Given>
class OptimumChecker {
 public:
  using Half = typename Given::Half;
  OptimumChecker(const Given& given, const Objective& objective, const LinearProgramAnswer& answer)
      : given_(given), objective_(objective), answer_(answer), no_objective_(objective.p == 0 && objective.q == 0) {
    if (!no_objective_) up_ = through_origin<Half>(objective.p, objective.q);
  }

  bool holds() const {
    const auto& [outcome, before, side, after, backward, cost] = answer_;
    for (const std::uint32_t k : {before, side, after}) {
      if (k != no_half_plane && k >= given_.size()) return false;
    }
    switch (outcome) {
      case Optimum::infeasible: return contradict(before, side, after);
      case Optimum::unbounded: return !no_objective_ && common_point(before, after) && never_leaves(side, backward);
      case Optimum::many: return !no_objective_ && is_edge();
      case Optimum::all: return no_objective_ && side == no_half_plane && common_point(before, after);
      case Optimum::one: return is_corner();
    }
    return false;
  }

 private:
  static bool is_set(std::uint32_t i) { return i != no_half_plane; }
  Sign turn_of(std::uint32_t i, std::uint32_t j) const { return turn(given_[i], given_[j]); }
  bool opposite(std::uint32_t i, std::uint32_t j) const {
    return turn_of(i, j) == Sign::zero && facing(given_[i], given_[j]) == Sign::negative;
  }

  bool contradict(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    if (!is_set(i) || !is_set(k)) return false;
    if (!is_set(j)) return opposite(i, k) && gap(given_[i], given_[k]) == Sign::negative;
    return turn_of(i, j) == Sign::positive && turn_of(j, k) == Sign::positive && turn_of(k, i) == Sign::positive &&
           corner_side(given_[i], given_[j], given_[k]) == Sign::positive;
  }

  // Is the corner of i and j common to all, j turning less than a half turn from i?
  bool holds_corner(std::uint32_t i, std::uint32_t j) const {
    if (turn_of(i, j) != Sign::positive) return false;
    for (std::uint32_t k = 0; k < given_.size(); ++k) {
      if (corner_side(given_[i], given_[j], given_[k]) == Sign::positive) return false;
    }
    return true;
  }

  // Is every point of the line of i common to all?
  bool holds_line(std::uint32_t i) const {
    for (std::uint32_t k = 0; k < given_.size(); ++k) {
      if (turn_of(i, k) != Sign::zero) return false;
      const bool same = facing(given_[i], given_[k]) == Sign::positive;
      if (same && tighter(given_[k], given_[i]) == Sign::positive) return false;
      if (!same && gap(given_[i], given_[k]) == Sign::negative) return false;
    }
    return true;
  }

  bool common_point(std::uint32_t i, std::uint32_t j) const {
    if (is_set(j)) {
      if (!is_set(i)) return false;
      return turn_of(i, j) == Sign::negative ? holds_corner(j, i) : holds_corner(i, j);
    }
    return is_set(i) ? holds_line(i) : given_.size() == 0;
  }

  // Along the line of i, forward or backward, each half-plane holds all that follows one of its points.
  bool stays(std::uint32_t i, bool backward) const {
    for (std::uint32_t k = 0; k < given_.size(); ++k) {
      if (turn_of(i, k) == (backward ? Sign::negative : Sign::positive)) return false;
    }
    return true;
  }

  bool never_leaves(std::uint32_t i, bool backward) const {
    if (is_set(i)) return turn(given_[i], up_) == (backward ? Sign::negative : Sign::positive) && stays(i, backward);
    for (std::uint32_t k = 0; k < given_.size(); ++k) {
      if (facing(given_[k], up_) == Sign::positive) return false;
    }
    return true;
  }

  bool is_up(std::uint32_t i) const {
    return turn(given_[i], up_) == Sign::zero && facing(given_[i], up_) == Sign::positive;
  }

  bool is_corner() const {
    const auto& [outcome, before, side, after, backward, cost] = answer_;
    if (no_objective_ || !is_set(before) || !is_set(after)) return false;
    if (!is_set(side)) {
      return turn(given_[before], up_) == Sign::positive && turn(up_, given_[after]) == Sign::positive &&
             holds_corner(before, after);
    }
    return is_up(side) && turn_of(side, after) == Sign::positive && holds_corner(before, side) &&
           corner_side(given_[before], given_[side], given_[after]) == Sign::zero;
  }

  bool is_edge() const {
    const auto& [outcome, before, side, after, backward, cost] = answer_;
    if (!is_set(side) || !is_up(side)) return false;
    if (is_set(before) ? !holds_corner(before, side) : !stays(side, true)) return false;
    if (is_set(after) ? !holds_corner(side, after) : !stays(side, false)) return false;
    if (!is_set(before) && !is_set(after)) return holds_line(side);
    return !is_set(before) || !is_set(after) ||
           corner_side(given_[before], given_[side], given_[after]) == Sign::negative;
  }

  const Given& given_;
  Objective objective_;
  const LinearProgramAnswer& answer_;
  bool no_objective_;
  Half up_{};
};

}  // namespace

template <class Given>
bool check(const Given& given, const Objective& objective, const LinearProgramAnswer& answer) {
  return OptimumChecker(given, objective, answer).holds();
}

template LinearProgramAnswer linear_program(const Constraints&, const Objective&);
template LinearProgramAnswer linear_program(const HalfPlanes&, const Objective&);
template ExactPoint2 point_of(const Constraints&, const LinearProgramAnswer&);
template ExactPoint2 point_of(const HalfPlanes&, const LinearProgramAnswer&);
template bool check(const Constraints&, const Objective&, const LinearProgramAnswer&);
template bool check(const HalfPlanes&, const Objective&, const LinearProgramAnswer&);

}  // namespace sunder::planar
