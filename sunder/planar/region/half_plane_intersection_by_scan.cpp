// Every line cut by all other half-planes: what is left of it is on the boundary. (The oracle.)
#include <sunder/planar/object/polygon_sides.h>
#include <sunder/planar/region/half_plane_intersection.h>

#include <algorithm>
#include <optional>

namespace sunder::planar {

namespace {

enum class Extent : std::uint8_t { nothing, point, more };

// What all half-planes leave of a line: counter-clockwise, from the line of `from` to that of `to`; unset: unbounded.
struct Left {
  Extent extent = Extent::more;
  std::optional<std::uint32_t> from, to;
};

template <class Given>
class HalfPlaneScan {
 public:
  explicit HalfPlaneScan(const Given& given) : given_(given) {}

  Region region() {
    Region region;
    for (std::uint32_t i = 0; i < given_.size(); ++i) left_.push_back(left_of_line(i));
    for (std::uint32_t i = 0; i < given_.size(); ++i) {
      if (left_[i].extent == Extent::more && is_lowest_equal(i)) region.sides.push_back(i);
    }
    std::sort(region.sides.begin(), region.sides.end(), [&](std::uint32_t i, std::uint32_t j) { return before(i, j); });
    settle(region);
    if (region.kind != RegionKind::empty) add_cones(region);
    region.cost = {probes_, 0, tally_.exact};
    return region;
  }

 private:
  Sign turn_of(std::uint32_t i, std::uint32_t j) { return ++probes_, turn(given_[i], given_[j], &tally_); }
  Sign side_of(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return ++probes_, corner_side(given_[i], given_[j], given_[k], &tally_);
  }
  bool antiparallel(std::uint32_t i, std::uint32_t j) {
    return turn_of(i, j) == Sign::zero && facing(given_[i], given_[j], &tally_) == Sign::negative;
  }
  bool parallel(std::uint32_t i, std::uint32_t j) {
    return turn_of(i, j) == Sign::zero && facing(given_[i], given_[j], &tally_) == Sign::positive;
  }
  bool one_line(std::uint32_t i, std::uint32_t j) {
    return antiparallel(i, j) && gap(given_[i], given_[j], &tally_) == Sign::zero;
  }
  bool equal(std::uint32_t i, std::uint32_t j) {
    return parallel(i, j) && tighter(given_[i], given_[j], &tally_) == Sign::zero;
  }
  bool is_lowest_equal(std::uint32_t i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      if (equal(i, j)) return false;
    }
    return true;
  }
  // By angle from the x axis on.
  bool before(std::uint32_t i, std::uint32_t j) {
    const bool down_i = points_down(given_[i]), down_j = points_down(given_[j]);
    return down_i != down_j ? down_j : turn_of(i, j) == Sign::positive;
  }

  Left left_of_line(std::uint32_t i) {
    Left left;
    for (std::uint32_t j = 0; j < given_.size(); ++j) {
      const Sign turn = turn_of(i, j);
      if (turn == Sign::zero) {
        const bool same = parallel(i, j);
        const bool gone = same ? tighter(given_[j], given_[i], &tally_) == Sign::positive
                               : gap(given_[i], given_[j], &tally_) == Sign::negative;
        if (gone) return {Extent::nothing, {}, {}};
      } else if (turn == Sign::positive) {  // nothing after their corner
        if (!left.to || side_of(i, *left.to, j) == Sign::positive) left.to = j;
      } else {
        if (!left.from || side_of(*left.from, i, j) == Sign::positive) left.from = j;
      }
    }
    if (left.from && left.to) {
      const Sign ends = side_of(*left.from, i, *left.to);
      left.extent = ends == Sign::negative ? Extent::more : ends == Sign::zero ? Extent::point : Extent::nothing;
    }
    return left;
  }

  void settle(Region& region) {
    std::vector<std::uint32_t>& sides = region.sides;
    for (const std::uint32_t i : sides) {
      for (const std::uint32_t j : sides) {
        if (one_line(i, j)) return settle_line(region, i, j);
      }
    }
    if (sides.empty()) return settle_none(region);
    if (sides.size() == 1) {
      region.kind = RegionKind::half_plane;
    } else if (sides.size() == 2 && antiparallel(sides[0], sides[1])) {
      region.kind = RegionKind::strip;
    } else {
      region.kind = RegionKind::bounded;
      for (std::size_t p = 0; p < sides.size(); ++p) {
        if (turn_of(sides[p], sides[(p + 1) % sides.size()]) == Sign::positive) continue;
        region.kind = RegionKind::unbounded;
        std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>((p + 1) % sides.size()), sides.end());
        break;
      }
    }
  }

  // The region lies on the line of i and j; the lowest equal ones of both.
  void settle_line(Region& region, std::uint32_t i, std::uint32_t j) {
    region.sides = {i, j};
    for (const std::uint32_t side : {i, j}) {
      if (!left_[side].to) continue;
      for (std::uint32_t k = 0; k < given_.size(); ++k) {
        if (turn_of(side, k) != Sign::positive || side_of(side, *left_[side].to, k) != Sign::zero) continue;
        region.sides.push_back(k);
        break;
      }
    }
    std::sort(region.sides.begin(), region.sides.end(), [&](std::uint32_t k, std::uint32_t l) { return before(k, l); });
    region.kind = region.sides.size() == 4   ? RegionKind::segment
                  : region.sides.size() == 3 ? RegionKind::ray
                                             : RegionKind::line;
    if (region.kind != RegionKind::ray) return;
    while (!antiparallel(region.sides[0], region.sides[2])) {
      std::rotate(region.sides.begin(), region.sides.begin() + 1, region.sides.end());
    }
  }

  void settle_none(Region& region) {
    for (std::uint32_t i = 0; i < given_.size(); ++i) {
      if (left_[i].extent == Extent::point) return settle_point(region, *left_[i].from, i);
    }
    if (given_.size() == 0) {
      region.kind = RegionKind::plane;
      return;
    }
    region.kind = RegionKind::empty;
    for (std::uint32_t i = 0; i < given_.size(); ++i) {
      for (std::uint32_t j = 0; j < given_.size(); ++j) {
        if (antiparallel(i, j) && gap(given_[i], given_[j], &tally_) == Sign::negative) {
          region.sides = {i, j};
          return;
        }
        if (turn_of(i, j) != Sign::positive) continue;
        for (std::uint32_t k = 0; k < given_.size(); ++k) {
          if (turn_of(j, k) != Sign::positive || turn_of(k, i) != Sign::positive) continue;
          if (side_of(i, j, k) != Sign::positive) continue;
          region.sides = {i, j, k};
          return;
        }
      }
    }
  }

  void settle_point(Region& region, std::uint32_t i, std::uint32_t j) {
    region.kind = RegionKind::point;
    std::vector<std::uint32_t> through;
    for (std::uint32_t k = 0; k < given_.size(); ++k) {
      if (side_of(i, j, k) == Sign::zero) through.push_back(k);
    }
    std::uint32_t side = through[0];
    for (int count = 0; count < 4; ++count) {
      region.sides.push_back(side);
      if (count > 1 && turn_of(side, through[0]) == Sign::positive) break;
      // The next one: no other is further and less than a half turn after `side`.
      const auto follows = [&](std::uint32_t k) { return turn_of(side, k) == Sign::positive; };
      for (const std::uint32_t k : through) {
        if (!follows(k)) continue;
        const bool is_last = std::none_of(through.begin(), through.end(), [&](std::uint32_t l) {
          return follows(l) && turn_of(k, l) == Sign::positive;
        });
        if (!is_last) continue;
        side = k;
        break;
      }
    }
    std::sort(region.sides.begin(), region.sides.end(), [&](std::uint32_t k, std::uint32_t l) { return before(k, l); });
  }

  // The first position of which the definition holds.
  void add_cones(Region& region) {
    const std::size_t n = region.sides.size();
    for (std::uint32_t k = 0; k < given_.size(); ++k) {
      const auto holds = [&](std::size_t p) {
        const std::uint32_t i = region.sides[p], j = region.sides[(p + 1) % n];
        if (turn_of(i, j) != Sign::positive) return n <= 2 && parallel(i, k);
        return turn_of(i, k) != Sign::negative && turn_of(k, j) != Sign::negative;
      };
      std::uint32_t p = 0;
      while (p + 1 < n && !holds(p)) ++p;
      region.cones.push_back(p);
    }
  }

  const Given& given_;
  std::vector<Left> left_;
  StageTally tally_;
  std::uint64_t probes_ = 0;
};

}  // namespace

template <class Given>
Region half_plane_intersection_by_scan(const Given& given, const RegionOptions& options) {
  Region region = HalfPlaneScan(given).region();
  if (!options.evidence) region.cones.clear();
  return region;
}

template Region half_plane_intersection_by_scan(const Constraints&, const RegionOptions&);
template Region half_plane_intersection_by_scan(const HalfPlanes&, const RegionOptions&);
template Region half_plane_intersection_by_scan(const PolygonSides&, const RegionOptions&);

}  // namespace sunder::planar
