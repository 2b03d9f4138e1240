// Every corner of two lines that is common to all. (The oracle.)
#include <sunder/planar/region/linear_program.h>

namespace sunder::planar {

namespace {

template <class Given>
class ProgramScan {
 public:
  using Half = typename Given::Half;
  ProgramScan(const Given& given, const Objective& objective)
      : given_(given), size_(given.size()), is_zero_(objective.p == 0 && objective.q == 0) {
    if (!is_zero_) up_ = through_origin<Half>(objective.p, objective.q);
  }

  LinearProgramAnswer answer() {
    LinearProgramAnswer answer;
    if (!finds_contradiction(answer)) {
      if (is_zero_) {
        name_common_point(answer);
        answer.outcome = Optimum::all;
      } else if (!finds_corner(answer) && !finds_edge(answer)) {
        name_common_point(answer);
        name_way(answer);
        answer.outcome = Optimum::unbounded;
      }
    }
    answer.cost = {probes_, 0, tally_.exact};
    return answer;
  }

 private:
  Sign turn_of(const Half& i, const Half& j) { return ++probes_, turn(i, j, &tally_); }
  Sign turn_of(std::uint32_t i, std::uint32_t j) { return turn_of(Half(given_[i]), Half(given_[j])); }
  Sign side_of(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return ++probes_, corner_side(given_[i], given_[j], given_[k], &tally_);
  }
  bool faces(const Half& i, const Half& j, Sign sign) {
    return turn_of(i, j) == Sign::zero && facing(i, j, &tally_) == sign;
  }

  bool holds_corner(std::uint32_t i, std::uint32_t j) {
    if (turn_of(i, j) != Sign::positive) return false;
    for (std::uint32_t k = 0; k < size_; ++k) {
      if (side_of(i, j, k) == Sign::positive) return false;
    }
    return true;
  }

  bool holds_line(std::uint32_t i) {
    for (std::uint32_t k = 0; k < size_; ++k) {
      if (turn_of(i, k) != Sign::zero) return false;
      const bool same = faces(given_[i], given_[k], Sign::positive);
      if (same && tighter(given_[k], given_[i], &tally_) == Sign::positive) return false;
      if (!same && gap(given_[i], given_[k], &tally_) == Sign::negative) return false;
    }
    return true;
  }

  bool finds_contradiction(LinearProgramAnswer& answer) {
    for (std::uint32_t i = 0; i < size_; ++i) {
      for (std::uint32_t j = 0; j < size_; ++j) {
        if (faces(given_[i], given_[j], Sign::negative) && gap(given_[i], given_[j], &tally_) == Sign::negative) {
          answer = {Optimum::infeasible, i, no_half_plane, j, false, {}};
          return true;
        }
        if (turn_of(i, j) != Sign::positive) continue;
        for (std::uint32_t k = 0; k < size_; ++k) {
          if (turn_of(j, k) != Sign::positive || turn_of(k, i) != Sign::positive) continue;
          if (side_of(i, j, k) != Sign::positive) continue;
          answer = {Optimum::infeasible, i, j, k, false, {}};
          return true;
        }
      }
    }
    return false;
  }

  void name_common_point(LinearProgramAnswer& answer) {
    for (std::uint32_t i = 0; i < size_; ++i) {
      if (holds_line(i)) answer.before = i;
      for (std::uint32_t j = 0; j < size_; ++j) {
        if (!holds_corner(i, j)) continue;
        answer.before = i;
        answer.after = j;
        return;
      }
    }
  }

  bool finds_corner(LinearProgramAnswer& answer) {
    for (std::uint32_t i = 0; i < size_; ++i) {
      if (turn_of(given_[i], up_) != Sign::positive) continue;
      for (std::uint32_t j = 0; j < size_; ++j) {
        if (turn_of(up_, given_[j]) != Sign::positive || !holds_corner(i, j)) continue;
        answer = {Optimum::one, i, no_half_plane, j, false, {}};
        return true;
      }
    }
    return false;
  }

  bool finds_edge(LinearProgramAnswer& answer) {
    for (std::uint32_t side = 0; side < size_; ++side) {
      if (!faces(given_[side], up_, Sign::positive)) continue;
      LinearProgramAnswer edge{Optimum::many, no_half_plane, side, no_half_plane, false, {}};
      for (std::uint32_t k = 0; k < size_; ++k) {
        if (holds_corner(k, side)) edge.before = k;
        if (holds_corner(side, k)) edge.after = k;
      }
      const bool has_before = edge.before != no_half_plane, has_after = edge.after != no_half_plane;
      if (!has_before && !has_after && !holds_line(side)) continue;
      if (has_before && has_after && side_of(edge.before, side, edge.after) == Sign::zero) edge.outcome = Optimum::one;
      answer = edge;
      return true;
    }
    return false;
  }

  bool never_leaves(Sign sign, std::uint32_t side) {
    for (std::uint32_t k = 0; k < size_; ++k) {
      if (turn_of(side, k) == sign) return false;
    }
    return true;
  }

  void name_way(LinearProgramAnswer& answer) {
    for (std::uint32_t side = 0; side < size_; ++side) {
      const Sign turn = turn_of(given_[side], up_);
      if (turn == Sign::zero || !never_leaves(turn, side)) continue;
      answer.side = side;
      answer.backward = turn == Sign::negative;
    }
  }

  const Given& given_;
  std::uint32_t size_;
  bool is_zero_;
  Half up_{};
  StageTally tally_;
  std::uint64_t probes_ = 0;
};

}  // namespace

template <class Given>
LinearProgramAnswer linear_program_by_scan(const Given& given, const Objective& objective) {
  return ProgramScan(given, objective).answer();
}

template LinearProgramAnswer linear_program_by_scan(const Constraints&, const Objective&);
template LinearProgramAnswer linear_program_by_scan(const HalfPlanes&, const Objective&);

}  // namespace sunder::planar
