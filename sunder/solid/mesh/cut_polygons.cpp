#include <sunder/solid/mesh/cut_polygons.h>

#include <algorithm>
#include <array>

namespace sunder::solid {

std::uint32_t CutPolygons::add_corner(EnclosedPoint at) {
  const auto middle = [](const Interval& x) { return x.low / 2 + x.high / 2; };
  near_.push_back({middle(at.about.x), middle(at.about.y), middle(at.about.z)});
  corners_.push_back(std::move(at));
  signs_.push_back({-1, Sign::zero});
  return static_cast<std::uint32_t>(corners_.size() - 1);
}

std::int32_t CutPolygons::add_plane(ExactPlane plane) {
  planes_.push_back(std::move(plane));
  return static_cast<std::int32_t>(planes_.size() - 1);
}

void CutPolygons::replace_plane(ExactPlane plane) {
  planes_.back() = std::move(plane);
  std::fill(signs_.begin(), signs_.end(), KnownSide{-1, Sign::zero});
}

CutPolygon CutPolygons::add_polygon(std::uint32_t of, std::span<const RingCorner> ring) {
  const CutPolygon made{of, static_cast<std::uint32_t>(ring_.size()), static_cast<std::uint32_t>(ring.size())};
  ring_.insert(ring_.end(), ring.begin(), ring.end());
  return made;
}

CutPolygonList CutPolygons::add_box(const Box3& box) {
  std::array<std::int32_t, 6> planes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    planes[2 * axis] = add_plane(ExactPlane::across_axis(axis, box.low[axis]));
    planes[2 * axis + 1] = add_plane(ExactPlane::across_axis(axis, box.high[axis]));
  }
  const auto first = static_cast<std::uint32_t>(corners_.size());
  for (std::uint32_t k = 0; k < 8; ++k) {
    add_corner(EnclosedPoint(exactly(
        Point3{(k & 1 ? box.high : box.low).x, (k & 2 ? box.high : box.low).y, (k & 4 ? box.high : box.low).z})));
  }
  // The corners of a facet in a cycle, counter-clockwise as seen from outside; each edge is on the plane that both its
  // ends are on.
  CutPolygonList facets;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t i = 1u << (axis + 1) % 3, j = 1u << (axis + 2) % 3;
    const std::int32_t* const u = &planes[2 * ((axis + 1) % 3)];
    const std::int32_t* const v = &planes[2 * ((axis + 2) % 3)];
    for (const std::uint32_t end : {0u, 1u}) {
      const std::uint32_t at = first + (end << axis);
      const std::array<RingCorner, 4> up{RingCorner{at, v[0]}, {at + i, u[1]}, {at + i + j, v[1]}, {at + j, u[0]}},
          down{RingCorner{at, u[0]}, {at + j, v[1]}, {at + i + j, u[1]}, {at + i, v[0]}};
      facets.push_back(add_polygon(static_cast<std::uint32_t>(planes[2 * axis + end]), end == 1 ? up : down));
    }
  }
  return facets;
}

Sign CutPolygons::sign_at(std::uint32_t corner, std::int32_t plane) {
  KnownSide& known = signs_[corner];
  if (known.plane != plane) {
    ++cost_.probes;
    StageTally tally;
    known = {plane, planes_[static_cast<std::size_t>(plane)].side_of(corners_[corner], &tally)};
    cost_.exact += tally.exact;
  }
  return known.sign;
}

std::pair<bool, bool> CutPolygons::above_and_below(const CutPolygon& polygon, std::int32_t plane) {
  bool above = false, below = false;
  for (std::uint32_t k = 0; k < polygon.size; ++k) {
    const Sign sign = sign_at(ring_[polygon.begin + k].corner, plane);
    above |= sign == Sign::positive;
    below |= sign == Sign::negative;
  }
  return {above, below};
}

bool CutPolygons::goes_through(const CutPolygonList& polygons, std::int32_t plane) {
  bool above = false, below = false;
  for (const CutPolygon& polygon : polygons) {
    const auto [has_above, has_below] = above_and_below(polygon, plane);
    above |= has_above;
    below |= has_below;
  }
  return above && below;
}

CutPolygonList CutPolygons::cut_cell(const CutPolygonList& facets, std::int32_t plane, Sign side) {
  struct Edge {
    std::uint32_t from, to;
    std::int32_t on;
  };
  CutPolygonList result;
  std::vector<Edge> rim;  // edges of the new facet
  for (const CutPolygon& facet : facets) {
    const auto [above, below] = above_and_below(facet, plane);
    if (!(side == Sign::positive ? above : below)) continue;
    CutPolygon kept = facet;
    if (above && below) {
      kept = clipped(facet, plane, side, [&](std::int32_t edge) {
        return add_corner(common_point(planes_[facet.of], planes_[static_cast<std::size_t>(edge)],
                                       planes_[static_cast<std::size_t>(plane)]));
      });
    }
    result.push_back(kept);
    for (std::uint32_t k = 0; k < kept.size; ++k) {
      const std::uint32_t here = ring_[kept.begin + k].corner, next = ring_[kept.begin + (k + 1) % kept.size].corner;
      if (sign_at(here, plane) == Sign::zero && sign_at(next, plane) == Sign::zero) {
        rim.push_back({next, here, static_cast<std::int32_t>(facet.of)});
      }
    }
  }
  CutPolygon cap{static_cast<std::uint32_t>(plane), static_cast<std::uint32_t>(ring_.size()), 0};
  std::uint32_t at = rim.empty() ? 0 : rim.front().from;
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const auto next = std::find_if(rim.begin() + static_cast<std::ptrdiff_t>(k), rim.end(),
                                   [&](const Edge& edge) { return are_equal(edge.from, at); });
    if (next == rim.end()) return {};
    std::swap(rim[k], *next);
    ring_.push_back({rim[k].from, rim[k].on});
    at = rim[k].to;
  }
  cap.size = static_cast<std::uint32_t>(rim.size());
  if (cap.size < 3) return {};
  result.push_back(cap);
  return result;
}

bool CutPolygons::are_equal(std::uint32_t i, std::uint32_t j) const {
  if (i == j) return true;
  const EnclosedPoint &p = corners_[i], &q = corners_[j];
  const auto are_apart = [](const Interval& x, const Interval& y) { return x.high < y.low || y.high < x.low; };
  if (are_apart(p.about.x, q.about.x) || are_apart(p.about.y, q.about.y) || are_apart(p.about.z, q.about.z)) {
    return false;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    if (!(p.exact[c] * q.exact.denominator == q.exact[c] * p.exact.denominator)) return false;
  }
  return true;
}

}  // namespace sunder::solid
