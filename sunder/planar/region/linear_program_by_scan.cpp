// Every corner of two lines that is common to all. (The oracle.)
#include <sunder/planar/region/linear_program.h>

#include <optional>

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
    LinearProgramAnswer answer{evidence(), DecidedBy::scan};
    answer.cost.probes = probes_;
    answer.cost.exact = tally_.exact;
    return answer;
  }

 private:
  ProgramEvidence evidence() {
    if (const std::optional<NoPoint> contradiction = find_contradiction()) return *contradiction;
    if (is_zero_) return find_common_point();
    if (const std::optional<OneOptimum> corner = find_corner()) return *corner;
    if (const std::optional<ProgramEvidence> edge = find_edge()) return *edge;
    return find_way();
  }

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

  std::optional<NoPoint> find_contradiction() {
    for (std::uint32_t i = 0; i < size_; ++i) {
      for (std::uint32_t j = 0; j < size_; ++j) {
        if (faces(given_[i], given_[j], Sign::negative) && gap(given_[i], given_[j], &tally_) == Sign::negative) {
          return NoPoint{i, j};
        }
        if (turn_of(i, j) != Sign::positive) continue;
        for (std::uint32_t k = 0; k < size_; ++k) {
          if (turn_of(j, k) != Sign::positive || turn_of(k, i) != Sign::positive) continue;
          if (side_of(i, j, k) != Sign::positive) continue;
          return NoPoint{i, k, j};
        }
      }
    }
    return std::nullopt;
  }

  AnyPoint find_common_point() {
    AnyPoint point;
    for (std::uint32_t i = 0; i < size_; ++i) {
      if (holds_line(i)) point.before = i;
      for (std::uint32_t j = 0; j < size_; ++j) {
        if (holds_corner(i, j)) return {i, j};
      }
    }
    return point;
  }

  std::optional<OneOptimum> find_corner() {
    for (std::uint32_t i = 0; i < size_; ++i) {
      if (turn_of(given_[i], up_) != Sign::positive) continue;
      for (std::uint32_t j = 0; j < size_; ++j) {
        if (turn_of(up_, given_[j]) == Sign::positive && holds_corner(i, j)) return OneOptimum{i, j};
      }
    }
    return std::nullopt;
  }

  std::optional<ProgramEvidence> find_edge() {
    for (std::uint32_t side = 0; side < size_; ++side) {
      if (!faces(given_[side], up_, Sign::positive)) continue;
      ManyOptima edge{side};
      for (std::uint32_t k = 0; k < size_; ++k) {
        if (holds_corner(k, side)) edge.before = k;
        if (holds_corner(side, k)) edge.after = k;
      }
      const bool has_before = edge.before != no_half_plane, has_after = edge.after != no_half_plane;
      if (!has_before && !has_after && !holds_line(side)) continue;
      if (has_before && has_after && side_of(edge.before, side, edge.after) == Sign::zero) {
        return OneOptimum{edge.before, edge.after, side};
      }
      return edge;
    }
    return std::nullopt;
  }

  bool never_leaves(Sign sign, std::uint32_t side) {
    for (std::uint32_t k = 0; k < size_; ++k) {
      if (turn_of(side, k) == sign) return false;
    }
    return true;
  }

  NoBound find_way() {
    NoBound far{find_common_point()};
    for (std::uint32_t side = 0; side < size_; ++side) {
      const Sign turn = turn_of(given_[side], up_);
      if (turn == Sign::zero || !never_leaves(turn, side)) continue;
      far.side = side;
      far.backward = turn == Sign::negative;
    }
    return far;
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
