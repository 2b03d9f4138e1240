#include <sunder/base/contract.h>
#include <sunder/base/names.h>
#include <sunder/planar/object/polygon_sides.h>
#include <sunder/planar/region/region.h>

#include <algorithm>

namespace sunder::planar {

std::string_view name_of(RegionKind kind) {
  return name_in<RegionKind::plane>(
      {"empty", "point", "segment", "ray", "line", "strip", "half-plane", "unbounded", "bounded", "plane"}, kind);
}

// Of a segment's four sides two are its ends, the first and third or the others: between one end and the other lie two
// steps.
std::vector<std::array<std::uint32_t, 2>> corners(const Region& region) {
  const std::size_t n = region.sides.size();
  const auto corner = [&](std::size_t p) { return std::array{region.sides[p], region.sides[p + 1 == n ? 0 : p + 1]}; };
  std::vector<std::array<std::uint32_t, 2>> all;
  switch (region.kind) {
    case RegionKind::point:
    case RegionKind::ray: return {corner(0)};
    case RegionKind::segment: return {corner(0), corner(2)};
    case RegionKind::bounded:
    case RegionKind::unbounded:
      for (std::size_t p = 0; p + (region.kind == RegionKind::bounded ? 0 : 1) < n; ++p) all.push_back(corner(p));
      return all;
    default: return all;
  }
}

template <class Given>
ExactPoint2 point_of(const Given& given, const Region& region) {
  SUNDER_REQUIRE(region.kind != RegionKind::empty);
  if (region.kind == RegionKind::plane) return {0.0, 0.0, 1.0};
  const bool has_corner =
      region.kind != RegionKind::half_plane && region.kind != RegionKind::strip && region.kind != RegionKind::line;
  const auto first = given[region.sides[0]];
  return has_corner ? exact_corner(first, given[region.sides[1]]) : exact_point_on(first);
}

// For two: the sizes of the other's normal, by a coordinate that is not zero. For three: the turns of the other two.
template <class Given>
std::vector<Dyadic> multipliers(const Given& given, const Region& region) {
  std::vector<ExactConstraint> side;
  for (const std::uint32_t i : region.sides) side.push_back(exact_constraint(given[i]));
  const auto size = [](const Dyadic& x) { return x.sign() == Sign::negative ? -x : x; };
  if (side.size() == 2) {
    if (side[0].a.sign() == Sign::zero) return {size(side[1].b), size(side[0].b)};
    return {size(side[1].a), size(side[0].a)};
  }
  const auto turn = [&](std::size_t i, std::size_t j) { return side[i].a * side[j].b - side[i].b * side[j].a; };
  return {turn(1, 2), turn(2, 0), turn(0, 1)};
}

namespace {

template <class Given>
class RegionChecker {
 public:
  RegionChecker(const Given& given, const Region& region) : given_(given), kind_(region.kind), sides_(region.sides) {}

  bool holds(const std::vector<std::uint32_t>& cones) const {
    for (const std::uint32_t side : sides_) {
      if (side >= given_.size()) return false;
    }
    if (kind_ == RegionKind::empty) return contradict();
    return shape_holds() && others_hold(cones);
  }

 private:
  auto side(std::size_t p) const { return given_[sides_[p % sides_.size()]]; }
  Sign turn_at(std::size_t p) const { return turn(side(p), side(p + 1)); }
  // Where the corner before side p lies to the side after it: negative: side p has extent.
  Sign end_of(std::size_t p) const { return corner_side(side(p + sides_.size() - 1), side(p), side(p + 1)); }
  bool opposite(std::size_t p, std::size_t q) const {
    return turn(side(p), side(q)) == Sign::zero && facing(side(p), side(q)) == Sign::negative;
  }

  bool turns_at_corners(std::size_t count) const {
    for (std::size_t p = 0; p < count; ++p) {
      if (turn_at(p) != Sign::positive) return false;
    }
    return true;
  }

  // Angles go once past the x axis, all turns being positive. Requires at least one side.
  bool goes_round_once() const {
    int wraps = 0;
    for (std::size_t p = 0; p < sides_.size(); ++p) {
      const bool down = points_down(side(p)), next_down = points_down(side(p + 1));
      wraps += down && !next_down ? 1 : 0;
    }
    return wraps == 1;
  }

  bool contradict() const {
    if (sides_.size() == 2) return opposite(0, 1) && gap(side(0), side(1)) == Sign::negative;
    return sides_.size() == 3 && turns_at_corners(3) && corner_side(side(0), side(1), side(2)) == Sign::positive;
  }

  bool ends_are(std::size_t first, std::size_t last, Sign wanted) const {
    for (std::size_t p = first; p < last; ++p) {
      if (end_of(p) != wanted) return false;
    }
    return true;
  }

  // The first and last side turn by a half turn or less, and so do all between.
  bool within_half_turn() const {
    const Sign whole = turn(side(0), side(sides_.size() - 1));
    if (whole == Sign::zero && !opposite(0, sides_.size() - 1)) return false;
    for (std::size_t p = 1; p + 1 < sides_.size(); ++p) {
      if (turn(side(0), side(p)) != Sign::positive) return false;
    }
    return whole != Sign::negative;
  }

  bool shape_holds() const {
    const std::size_t n = sides_.size();
    switch (kind_) {
      case RegionKind::empty: return false;
      case RegionKind::plane: return n == 0;
      case RegionKind::half_plane: return n == 1;
      case RegionKind::line: return n == 2 && opposite(0, 1) && gap(side(0), side(1)) == Sign::zero;
      case RegionKind::strip: return n == 2 && opposite(0, 1) && gap(side(0), side(1)) == Sign::positive;
      case RegionKind::ray:
        return n == 3 && turns_at_corners(2) && opposite(0, 2) && gap(side(0), side(2)) == Sign::zero;
      case RegionKind::unbounded:
        return n >= 2 && turns_at_corners(n - 1) && within_half_turn() && ends_are(1, n - 1, Sign::negative) &&
               !(opposite(0, n - 1) && gap(side(0), side(n - 1)) != Sign::positive);
      case RegionKind::bounded:
        return n >= 3 && turns_at_corners(n) && goes_round_once() && ends_are(0, n, Sign::negative);
      case RegionKind::point: return n >= 3 && turns_at_corners(n) && goes_round_once() && ends_are(0, n, Sign::zero);
      case RegionKind::segment: return is_segment();
    }
    return false;
  }

  // Two antiparallel sides in one line, with extent; the others have a point each.
  bool is_segment() const {
    if (sides_.size() != 4 || !turns_at_corners(4) || !goes_round_once()) return false;
    const std::size_t first = end_of(0) == Sign::negative ? 0 : 1;
    return opposite(first, first + 2) && gap(side(first), side(first + 2)) == Sign::zero &&
           end_of(first) == Sign::negative && end_of(first + 2) == Sign::negative;
  }

  bool others_hold(const std::vector<std::uint32_t>& cones) const {
    if (cones.size() != given_.size()) return false;
    const std::size_t n = sides_.size();
    const bool no_corner = kind_ == RegionKind::half_plane || kind_ == RegionKind::line || kind_ == RegionKind::strip;
    const bool open = kind_ == RegionKind::ray || kind_ == RegionKind::unbounded;
    for (std::uint32_t k = 0; k < given_.size(); ++k) {
      const std::size_t p = cones[k];
      if (p >= n - (open ? 1 : 0)) return false;
      const auto other = given_[k];
      if (no_corner) {
        if (turn(side(p), other) != Sign::zero || facing(side(p), other) != Sign::positive) return false;
        if (tighter(other, side(p)) == Sign::positive) return false;
      } else {
        if (turn(side(p), other) == Sign::negative || turn(other, side(p + 1)) == Sign::negative) return false;
        if (corner_side(side(p), side(p + 1), other) == Sign::positive) return false;
      }
    }
    return true;
  }

  const Given& given_;
  RegionKind kind_;
  const std::vector<std::uint32_t>& sides_;
};

}  // namespace

template <class Given>
bool check(const Given& given, const Region& region) {
  return RegionChecker(given, region).holds(region.cones);
}

template ExactPoint2 point_of(const Constraints&, const Region&);
template ExactPoint2 point_of(const HalfPlanes&, const Region&);
template ExactPoint2 point_of(const PolygonSides&, const Region&);
template std::vector<Dyadic> multipliers(const Constraints&, const Region&);
template std::vector<Dyadic> multipliers(const HalfPlanes&, const Region&);
template std::vector<Dyadic> multipliers(const PolygonSides&, const Region&);
template bool check(const Constraints&, const Region&);
template bool check(const HalfPlanes&, const Region&);
template bool check(const PolygonSides&, const Region&);

}  // namespace sunder::planar
