#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/planar/object/polygon_sides.h>
#include <sunder/planar/region/angle_order.h>
#include <sunder/planar/region/region_search.h>

namespace sunder::planar {

namespace {

using Sides = std::vector<std::uint32_t>;

// The lowest one that has the corner of i and j in its line and turns from i as j does.
template <class Given>
std::uint32_t lowest_end(Signs<Given>& signs, std::uint32_t i, std::uint32_t j) {
  for (std::uint32_t k = 0; k < j; ++k) {
    if (signs.turn(i, k) == Sign::positive && signs.corner_side(i, j, k) == Sign::zero) return k;
  }
  return j;
}

template <class Given>
void sort_by_angle(Signs<Given>& signs, Sides& sides) {
  std::sort(sides.begin(), sides.end(), [&](std::uint32_t k, std::uint32_t l) { return signs.is_before(k, l); });
}

// Where the region is the corner of i and j alone.
template <class Given>
Sides sides_of_point(Signs<Given>& signs, std::uint32_t i, std::uint32_t j) {
  Sides through;
  for (std::uint32_t k = 0; k < signs.given().size(); ++k) {
    if (signs.corner_side(i, j, k) == Sign::zero) through.push_back(k);
  }
  Sides sides{through[0]};
  do {
    std::optional<std::uint32_t> last;
    for (const std::uint32_t k : through) {
      if (signs.turn(sides.back(), k) != Sign::positive) continue;
      if (!last || signs.turn(*last, k) == Sign::positive) last = k;
    }
    sides.push_back(*last);
  } while (signs.turn(sides.back(), sides.front()) != Sign::positive);
  sort_by_angle(signs, sides);
  return sides;
}

// Has side p, between two others, more than a point of the boundary? Within a chain each has; `chain` sides are of the
// first one.
template <class Given>
bool has_extent(Signs<Given>& signs, const Sides& sides, std::size_t chain, std::size_t p) {
  const std::size_t n = sides.size();
  if (p > 0 && p + 1 != chain && p != chain && p + 1 < n) return true;
  return signs.corner_side(sides[p == 0 ? n - 1 : p - 1], sides[p], sides[p + 1 == n ? 0 : p + 1]) == Sign::negative;
}

// The sides that have, of sides that turn around once.
template <class Given>
Sides sides_with_extent(Signs<Given>& signs, const Sides& sides, std::size_t chain) {
  Sides kept;
  kept.reserve(sides.size());
  for (std::size_t p = 0; p < sides.size(); ++p) {
    if (p % 1024 == 0) may_be_interrupted(1024);
    if (has_extent(signs, sides, chain, p)) kept.push_back(sides[p]);
  }
  return kept;
}

// What is closed has two dimensions, and three sides with extent or more, or it is a segment, and has two, or a point.
template <class Given>
void settle_closed(Signs<Given>& signs, Region& region, std::size_t chain) {
  const Sides sides = std::exchange(region.sides, {});
  region.sides = sides_with_extent(signs, sides, chain);
  if (region.sides.size() >= 3) {
    region.kind = RegionKind::bounded;
  } else if (region.sides.size() == 2) {
    region.kind = RegionKind::segment;
    for (const std::uint32_t side : {region.sides[0], region.sides[1]}) {
      const auto next = std::find(sides.begin(), sides.end(), side) + 1;
      region.sides.push_back(lowest_end(signs, side, next == sides.end() ? sides[0] : *next));
    }
    sort_by_angle(signs, region.sides);
  } else {
    region.kind = RegionKind::point;
    region.sides = sides_of_point(signs, sides[0], sides[1]);
  }
}

template <class Given>
void settle_open(Signs<Given>& signs, Region& region, std::size_t chain) {
  Sides& sides = region.sides;
  const std::size_t n = sides.size();
  if (n < 2) {
    region.kind = n == 0 ? RegionKind::plane : RegionKind::half_plane;
    return;
  }
  const bool antiparallel = signs.turn(sides.front(), sides.back()) == Sign::zero;
  const bool flat = antiparallel && signs.gap(sides.front(), sides.back()) == Sign::zero;
  if (n == 2 && antiparallel) {
    region.kind = flat ? RegionKind::line : RegionKind::strip;
  } else if (flat) {
    region.kind = RegionKind::ray;
    sides = {sides.front(), lowest_end(signs, sides.front(), sides[1]), sides.back()};
  } else {
    region.kind = RegionKind::unbounded;
    Sides kept{sides.front()};
    for (std::size_t p = 1; p + 1 < n; ++p) {
      if (has_extent(signs, sides, chain, p)) kept.push_back(sides[p]);
    }
    kept.push_back(sides.back());
    sides = std::move(kept);
  }
}

}  // namespace

// By a binary search; of sides without a corner by direction.
template <class Given>
std::uint32_t cone_of(Signs<Given>& signs, const Region& region, std::uint32_t k) {
  const Sides& sides = region.sides;
  const auto last = static_cast<std::uint32_t>(sides.size()) - 1;
  const auto position = [&](const auto& is_after) {
    const auto first_after =
        std::partition_point(sides.begin(), sides.end(), [&](std::uint32_t side) { return !is_after(side); });
    return first_after == sides.begin() ? last : static_cast<std::uint32_t>(first_after - sides.begin()) - 1;
  };
  switch (region.kind) {
    case RegionKind::bounded:
    case RegionKind::segment:
    case RegionKind::point:
      return position([&](std::uint32_t side) {
        if (signs.points_down(side) != signs.points_down(k)) return signs.points_down(side);
        return signs.turn(side, k) == Sign::negative;
      });
    case RegionKind::unbounded:
    case RegionKind::ray: {  // all normals are within a half turn from that of the first side
      const auto is_after = [&](std::uint32_t side) {
        const Sign turn = signs.turn(side, k);
        return turn == Sign::negative ||
               (turn == Sign::zero && side != sides[0] && signs.facing(side, k) == Sign::negative);
      };
      return std::min(position(is_after), last - 1);
    }
    default: return signs.same_direction(sides[0], k) ? 0 : last;
  }
}

template <class Given>
Region region_of(Signs<Given>& signs, const Chains& chains, const RegionOptions& options) {
  Region region;
  if (!chains.contradiction.empty()) {
    region.kind = RegionKind::empty;
    region.sides = chains.contradiction;
  } else {
    region.sides = sides_in_turn(chains);
    const std::size_t chain = first_of(chains).size();
    chains.right&& chains.left ? settle_closed(signs, region, chain) : settle_open(signs, region, chain);
    if (options.evidence) add_cones(signs, region);
  }
  signs.add_to(region.cost);
  return region;
}

template <class Given>
void add_cones(Signs<Given>& signs, Region& region) {
  SUNDER_REQUIRE(region.kind != RegionKind::empty);
  region.cones.resize(signs.given().size());
  const bool has_corner = region.sides.size() > 2 || region.kind == RegionKind::unbounded;
  if (!has_corner) {
    for (std::uint32_t k = 0; k < signs.given().size(); ++k) region.cones[k] = cone_of(signs, region, k);
    return;
  }
  const SideTable table(signs.given(), region.sides);
  for (std::uint32_t k = 0; k < signs.given().size(); ++k) {
    const std::optional<std::uint32_t> cone = cone_in(signs, region, table, k);
    region.cones[k] = cone ? *cone : cone_of(signs, region, k);
  }
}

template Region region_of(Signs<Constraints>&, const Chains&, const RegionOptions&);
template Region region_of(Signs<HalfPlanes>&, const Chains&, const RegionOptions&);
template Region region_of(Signs<PolygonSides>&, const Chains&, const RegionOptions&);
template std::uint32_t cone_of(Signs<Constraints>&, const Region&, std::uint32_t);
template std::uint32_t cone_of(Signs<HalfPlanes>&, const Region&, std::uint32_t);
template std::uint32_t cone_of(Signs<PolygonSides>&, const Region&, std::uint32_t);
template void add_cones(Signs<Constraints>&, Region&);
template void add_cones(Signs<HalfPlanes>&, Region&);
template void add_cones(Signs<PolygonSides>&, Region&);

}  // namespace sunder::planar
