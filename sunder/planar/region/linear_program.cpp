#include <sunder/base/contract.h>
#include <sunder/planar/region/linear_program.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <variant>

namespace sunder::planar {

namespace {

// Are these, where there are such, numbers of half-planes?
bool are_below(std::uint32_t size, std::initializer_list<std::uint32_t> numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [size](std::uint32_t k) { return k == no_half_plane || k < size; });
}

AnyPoint named_by(const OneOptimum& one) { return {one.before, one.side != no_half_plane ? one.side : one.after}; }
AnyPoint named_by(const ManyOptima& many) {
  if (many.before != no_half_plane) return {many.before, many.side};
  return {many.side, many.after};
}
AnyPoint named_by(const AnyPoint& any) { return any; }
AnyPoint named_by(const NoBound& far) { return far.from; }
AnyPoint named_by(const NoPoint&) { return {}; }

}  // namespace

AnyPoint named_point(const ProgramEvidence& evidence) {
  SUNDER_REQUIRE(!std::holds_alternative<NoPoint>(evidence));
  return std::visit([](const auto& held) { return named_by(held); }, evidence);
}

template <class Given>
LinearProgramAnswer linear_program(const Given& given, const Objective& objective) {
  return linear_program_by_sampling(given, objective);
}

template <class Given>
ExactPoint2 point_of(const Given& given, const LinearProgramAnswer& answer) {
  const auto [before, after] = named_point(answer.evidence);
  if (after != no_half_plane) return exact_corner(given[before], given[after]);
  if (before != no_half_plane) return exact_point_on(given[before]);
  return {0.0, 0.0, 1.0};
}

namespace {

template <class Given>
class OptimumChecker {
 public:
  using Half = typename Given::Half;
  OptimumChecker(const Given& given, const Objective& objective)
      : given_(given), no_objective_(objective.p == 0 && objective.q == 0) {
    if (!no_objective_) up_ = through_origin<Half>(objective.p, objective.q);
  }

  bool holds(const OneOptimum& one) const {
    const auto& [before, after, side] = one;
    if (no_objective_ || !is_set(before) || !is_set(after) || !are_below(given_.size(), {before, after, side})) {
      return false;
    }
    if (!is_set(side)) {
      return turn(given_[before], up_) == Sign::positive && turn(up_, given_[after]) == Sign::positive &&
             holds_corner(before, after);
    }
    return is_up(side) && turn_of(side, after) == Sign::positive && holds_corner(before, side) &&
           corner_side(given_[before], given_[side], given_[after]) == Sign::zero;
  }

  bool holds(const ManyOptima& many) const {
    const auto& [side, before, after] = many;
    if (no_objective_ || !are_below(given_.size(), {before, after, side})) return false;
    if (!is_set(side) || !is_up(side)) return false;
    if (is_set(before) ? !holds_corner(before, side) : !stays(side, true)) return false;
    if (is_set(after) ? !holds_corner(side, after) : !stays(side, false)) return false;
    if (!is_set(before) && !is_set(after)) return holds_line(side);
    return !is_set(before) || !is_set(after) ||
           corner_side(given_[before], given_[side], given_[after]) == Sign::negative;
  }

  bool holds(const AnyPoint& any) const { return no_objective_ && is_common(any); }

  bool holds(const NoBound& far) const {
    return !no_objective_ && are_below(given_.size(), {far.side}) && is_common(far.from) &&
           never_leaves(far.side, far.backward);
  }

  bool holds(const NoPoint& contradiction) const {
    const auto& [before, after, side] = contradiction;
    if (!is_set(before) || !is_set(after) || !are_below(given_.size(), {before, after, side})) return false;
    if (!is_set(side)) return opposite(before, after) && gap(given_[before], given_[after]) == Sign::negative;
    return turn_of(before, side) == Sign::positive && turn_of(side, after) == Sign::positive &&
           turn_of(after, before) == Sign::positive &&
           corner_side(given_[before], given_[side], given_[after]) == Sign::positive;
  }

 private:
  static bool is_set(std::uint32_t i) { return i != no_half_plane; }
  Sign turn_of(std::uint32_t i, std::uint32_t j) const { return turn(given_[i], given_[j]); }
  bool opposite(std::uint32_t i, std::uint32_t j) const {
    return turn_of(i, j) == Sign::zero && facing(given_[i], given_[j]) == Sign::negative;
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

  bool is_common(const AnyPoint& point) const {
    const auto& [i, j] = point;
    if (!are_below(given_.size(), {i, j})) return false;
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
    return !backward;
  }

  bool is_up(std::uint32_t i) const {
    return turn(given_[i], up_) == Sign::zero && facing(given_[i], up_) == Sign::positive;
  }

  const Given& given_;
  bool no_objective_;
  Half up_{};
};

}  // namespace

template <class Given>
bool check(const Given& given, const Objective& objective, const LinearProgramAnswer& answer) {
  const OptimumChecker checker(given, objective);
  return std::visit([&](const auto& held) { return checker.holds(held); }, answer.evidence);
}

template LinearProgramAnswer linear_program(const Constraints&, const Objective&);
template LinearProgramAnswer linear_program(const HalfPlanes&, const Objective&);
template ExactPoint2 point_of(const Constraints&, const LinearProgramAnswer&);
template ExactPoint2 point_of(const HalfPlanes&, const LinearProgramAnswer&);
template bool check(const Constraints&, const Objective&, const LinearProgramAnswer&);
template bool check(const HalfPlanes&, const Objective&, const LinearProgramAnswer&);

}  // namespace sunder::planar
