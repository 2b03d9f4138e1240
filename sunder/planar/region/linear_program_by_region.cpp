// A binary search over the sides of a region, which are sorted by angle (SH76, section V: "a line of support").
#include <sunder/planar/pair/edge_runs.h>
#include <sunder/planar/region/linear_program.h>

#include <cstddef>
#include <optional>

namespace sunder::planar {

namespace {

template <class Given>
class Support {
 public:
  using Half = typename Given::Half;
  Support(const Given& given, const Region& region, const Objective& objective, const PreparedRegion<Given>* prepared)
      : given_(given), region_(region), prepared_(prepared), up_(through_origin<Half>(objective.p, objective.q)) {}

  LinearProgramAnswer answer() {
    LinearProgramAnswer answer{evidence()};
    answer.cost.probes = probes_;
    conclude(answer, tally_.exact);
    return answer;
  }

  // For the objective zero.
  static LinearProgramAnswer any_point(const Region& region) {
    if (region.empty()) return {contradiction(region)};
    const auto& s = region.sides;
    const bool has_corner = region.kind != RegionKind::half_plane && region.kind != RegionKind::strip &&
                            region.kind != RegionKind::line && region.kind != RegionKind::plane;
    return {AnyPoint{s.empty() ? no_half_plane : s[0], has_corner ? s[1] : no_half_plane}};
  }

 private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(region_.sides.size()); }
  std::uint32_t number(std::size_t p) const { return prepared_ ? prepared_->sides()[p].number : region_.sides[p]; }
  Half side(std::size_t p) const { return prepared_ ? prepared_->sides()[p].half : given_[region_.sides[p]]; }
  Sign turn_to_up(std::size_t p) { return ++probes_, turn(side(p), up_, &tally_); }
  bool is_up(std::size_t p) { return turn_to_up(p) == Sign::zero && facing(side(p), up_, &tally_) == Sign::positive; }

  // Of the positions from one to another: the first one after the objective.
  std::uint32_t first_after_up(std::uint32_t low, std::uint32_t high) {
    return first_where(low, high, [&](std::uint32_t p) { return turn_to_up(p) == Sign::negative; });
  }

  ProgramEvidence evidence() {
    switch (region_.kind) {
      case RegionKind::empty: return contradiction(region_);
      case RegionKind::plane: return NoBound{};
      case RegionKind::half_plane:
      case RegionKind::strip:
      case RegionKind::line: return without_corner();
      case RegionKind::ray:
      case RegionKind::unbounded: return open();
      case RegionKind::point:
      case RegionKind::segment:
      case RegionKind::bounded: break;
    }
    return closed();
  }

  static NoPoint contradiction(const Region& region) {
    const auto& s = region.sides;
    return {s.front(), s.back(), s.size() == 3 ? s[1] : no_half_plane};
  }

  ProgramEvidence without_corner() {
    const std::vector<std::uint32_t>& sides = region_.sides;
    for (std::size_t p = 0; p < sides.size(); ++p) {
      if (is_up(p)) return ManyOptima{sides[p]};
    }
    const Sign turn = turn_to_up(0);
    return NoBound{{sides[0]}, turn == Sign::zero ? no_half_plane : sides[0], turn == Sign::negative};
  }

  // The evidence where the objective's direction is that of side p, or between those of it and the next.
  ProgramEvidence at(std::size_t p) {
    const std::size_t n = region_.sides.size();
    const bool is_closed = region_.kind != RegionKind::ray && region_.kind != RegionKind::unbounded;
    const std::uint32_t next = p + 1 < n ? number(p + 1) : is_closed ? number(0) : no_half_plane;
    if (!is_up(p)) return OneOptimum{number(p), next};
    const std::uint32_t previous = p > 0 ? number(p - 1) : is_closed ? number(n - 1) : no_half_plane;
    const bool is_flat =
        region_.kind == RegionKind::point || region_.kind == RegionKind::segment || region_.kind == RegionKind::ray;
    if (is_flat && previous != no_half_plane && next != no_half_plane) {
      ++probes_;
      const Sign end = corner_side(given_[previous], side(p), given_[next], &tally_);
      if (end == Sign::zero) return OneOptimum{previous, next, number(p)};
    }
    return ManyOptima{number(p), previous, next};
  }

  // Among the sides of nearly the objective's angle: the position of the last side that is not after it, where the next
  // one is. Both are asked, since the table is rounded.
  std::optional<std::size_t> position_by_table() {
    if (!prepared_) return std::nullopt;
    const auto [begin, end] = prepared_->around(up_);
    const std::size_t first = first_after_up(begin, end);
    const std::size_t n = region_.sides.size(), p = (first == 0 ? n : first) - 1, next = first == n ? 0 : first;
    const bool is_between = turn_to_up(p) != Sign::negative && turn_to_up(next) == Sign::negative;
    return is_between ? std::optional(p) : std::nullopt;
  }

  // Sides begin at the x axis.
  ProgramEvidence closed() {
    if (const std::optional<std::size_t> p = position_by_table()) return at(*p);
    const bool down = points_down(up_);
    const std::uint32_t n = size();
    const std::uint32_t first = first_where(0, n, [&](std::uint32_t p) {
      const Half half = side(p);
      const bool half_down = points_down(half);
      return half_down != down ? half_down : (++probes_, turn(up_, half, &tally_) == Sign::positive);
    });
    return at((first == 0 ? n : first) - 1);
  }

  // Sides lie within a half turn, and where the objective is not between them, it is in the gap.
  ProgramEvidence open() {
    const std::size_t n = region_.sides.size();
    if (is_up(0)) return at(0);
    if (is_up(n - 1)) return at(n - 1);
    const bool forward = turn_to_up(n - 1) == Sign::positive, backward = turn_to_up(0) == Sign::negative;
    if (forward || backward) return NoBound{{number(0), number(1)}, number(forward ? n - 1 : 0), !forward};
    if (const std::optional<std::size_t> p = position_by_table()) return at(*p);
    return at(first_after_up(1, size() - 1) - 1);
  }

  const Given& given_;
  const Region& region_;
  const PreparedRegion<Given>* prepared_;  // where there is one
  Half up_;
  StageTally tally_;
  std::uint64_t probes_ = 0;
};

}  // namespace

template <class Given>
LinearProgramAnswer linear_program_by_region(const Given& given, const Region& region, const Objective& objective) {
  if (objective.p == 0 && objective.q == 0) return Support<Given>::any_point(region);
  return Support<Given>(given, region, objective, nullptr).answer();
}

template <class Given>
LinearProgramAnswer linear_program_by_region(const PreparedRegion<Given>& prepared, const Objective& objective) {
  if (objective.p == 0 && objective.q == 0) return Support<Given>::any_point(prepared.region());
  return Support<Given>(prepared.given(), prepared.region(), objective, &prepared).answer();
}

template LinearProgramAnswer linear_program_by_region(const Constraints&, const Region&, const Objective&);
template LinearProgramAnswer linear_program_by_region(const HalfPlanes&, const Region&, const Objective&);
template LinearProgramAnswer linear_program_by_region(const PreparedRegion<Constraints>&, const Objective&);
template LinearProgramAnswer linear_program_by_region(const PreparedRegion<HalfPlanes>&, const Objective&);

}  // namespace sunder::planar
