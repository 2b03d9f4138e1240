#include <sunder/solid/mesh/cut_polygons.h>

#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sunder::solid {

namespace {

// Wider than this part of all there is, an enclosure is of no use to tell about where a corner is.
constexpr double too_wide = 0x1p-40;

Point3 middle_of(const Vector3<Interval>& v) {
  return {v.x.low / 2 + v.x.high / 2, v.y.low / 2 + v.y.high / 2, v.z.low / 2 + v.z.high / 2};
}

Vector3<Interval> image_about(const Posed3& p) {
  const Box3 box = enclosure(p);
  return {{box.low.x, box.high.x}, {box.low.y, box.high.y}, {box.low.z, box.high.z}};
}

ExactPoint3 exact_image(const Posed3& p) { return exact_point(coordinates<Dyadic>(p)); }

}  // namespace

CutPolygons::CutPolygons(const PlacedMesh& a, const PlacedMesh& b) : meshes_{&a, &b} {
  for (const std::size_t m : {0u, 1u}) {
    point_signs_[m].resize(meshes_[m]->mesh().points().size());
    const Box3 box = meshes_[m]->node_box(1);
    for (std::size_t c = 0; c < 3; ++c) size_ = std::max({size_, std::fabs(box.low[c]), std::fabs(box.high[c])});
  }
}

std::int32_t CutPolygons::add_plane(ExactPlane plane) {
  planes_.push_back(std::move(plane));
  last_through_.reset();
  for (std::optional<PlacedPlane>& seen : last_seen_) seen.reset();
  on_last_.clear();
  return last();
}

std::int32_t CutPolygons::add_plane(const TriangleNumber& through) {
  add_plane(plane_through(through.mesh, through.triangle));
  last_through_ = through;
  return last();
}

void CutPolygons::remove_plane() {
  for (std::vector<KnownSide>* of : {&signs_, &point_signs_[0], &point_signs_[1]}) {
    for (KnownSide& known : *of) {
      if (known.plane == last()) known.plane = -1;
    }
  }
  planes_.pop_back();
}

const ExactPlane& CutPolygons::plane_through(std::size_t mesh, std::uint32_t triangle) const {
  auto found = triangle_planes_[mesh].find(triangle);
  if (found == triangle_planes_[mesh].end()) {
    const PosedTriangle t = meshes_[mesh]->triangle(triangle);
    ExactPlane plane =
        ExactPlane::through(coordinates<Dyadic>(t[0]), coordinates<Dyadic>(t[1]), coordinates<Dyadic>(t[2]));
    found = triangle_planes_[mesh].emplace(triangle, std::move(plane)).first;
  }
  return found->second;
}

// ---- Corners.

std::uint32_t CutPolygons::add_corner(Made made, std::size_t mesh, const std::array<std::uint32_t, 3>& by) {
  Corner corner{{}, {}, made, static_cast<std::uint8_t>(mesh), -1, by};
  if (made == Made::point) {
    const Vector3<double> image = rounded_image(meshes_[mesh]->at(by[0]));
    corner.near = {image.x, image.y, image.z};
  } else {
    const auto is_narrow = [&](const Interval& x) { return x.high - x.low <= too_wide * size_; };
    if (const auto about = enclosure_of(corner);
        about && is_narrow(about->x) && is_narrow(about->y) && is_narrow(about->z)) {
      corner.about = *about;
    } else {
      EnclosedPoint exactly = made_exactly(corner);
      corner.about = exactly.about;
      corner.exact = static_cast<std::int32_t>(exact_.size());
      exact_.push_back(std::move(exactly.exact));
    }
    corner.near = middle_of(corner.about);
  }
  corners_.push_back(corner);
  signs_.emplace_back();
  return static_cast<std::uint32_t>(corners_.size() - 1);
}

std::optional<Vector3<Interval>> CutPolygons::enclosure_of(const Corner& corner) {
  const auto& [i, j, k] = corner.by;
  const PlacedMesh& mesh = *meshes_[corner.mesh];
  switch (corner.made) {
    case Made::point: return image_about(mesh.at(i));
    case Made::on_edge: return crossing_about(planes_[k], image_about(mesh.at(i)), image_about(mesh.at(j)));
    case Made::on_triangle: return common_point_about(plane_through(corner.mesh, i), planes_[j], planes_[k]);
    case Made::by_planes: break;
  }
  return common_point_about(planes_[i], planes_[j], planes_[k]);
}

EnclosedPoint CutPolygons::made_exactly(const Corner& corner) const {
  const auto& [i, j, k] = corner.by;
  const PlacedMesh& mesh = *meshes_[corner.mesh];
  switch (corner.made) {
    case Made::point: return EnclosedPoint(exact_image(mesh.at(i)));
    case Made::on_edge: return crossing_of(planes_[k], exact_image(mesh.at(i)), exact_image(mesh.at(j)));
    case Made::on_triangle: return common_point(plane_through(corner.mesh, i), planes_[j], planes_[k]);
    case Made::by_planes: break;
  }
  return common_point(planes_[i], planes_[j], planes_[k]);
}

ExactPoint3 CutPolygons::exact(std::uint32_t corner) const {
  const Corner& of = corners_[corner];
  return of.exact >= 0 ? exact_[static_cast<std::size_t>(of.exact)] : made_exactly(of).exact;
}

// ---- Sides of the last plane.

const PlacedPlane& CutPolygons::last_seen_by(std::size_t mesh) {
  std::optional<PlacedPlane>& seen = last_seen_[mesh];
  if (seen) return *seen;
  const PlacedMesh& placed = *meshes_[mesh];
  ExactPlane plane = planes_.back().seen_from(placed.pose().affine());
  if (last_through_) {
    // The same plane has fewer digits as the triangle tells it in its own frame, if that is the frame of this mesh.
    const PlacedMesh& of = *meshes_[last_through_->mesh];
    const Mesh::Triangle& t = of.mesh().triangles()[last_through_->triangle];
    const auto at = [&](std::size_t k) { return coordinates<Dyadic>(of.mesh().points()[t[k]]); };
    if (of.pose().affine() == placed.pose().affine()) {
      ExactPlane own = ExactPlane::through(at(0), at(1), at(2));
      const Guess side = sign(dot(plane.normal_about, own.normal_about));
      if (side == Guess::negative) own = {{-own.normal.x, -own.normal.y, -own.normal.z}, -own.offset};
      if (is_sure(side) && side != Guess::zero) plane = std::move(own);
    }
  }
  return seen.emplace(std::move(plane), placed);
}

// As what makes the corner and the plane tells.
bool CutPolygons::is_on_last(const Corner& corner) const {
  const auto k = static_cast<std::uint32_t>(last());
  const auto& by = corner.by;
  switch (corner.made) {
    case Made::point: return false;
    case Made::on_edge: return by[2] == k;
    case Made::on_triangle:
      return by[1] == k || by[2] == k ||
             (last_through_ && last_through_->mesh == corner.mesh && by[0] == last_through_->triangle);
    case Made::by_planes: break;
  }
  return by[0] == k || by[1] == k || by[2] == k;
}

Sign CutPolygons::side_of(Corner& corner, StageTally& tally) {
  if (is_on_last(corner)) return Sign::zero;
  const ExactPlane& plane = planes_.back();
  const Guess guess = sign(dot(plane.normal_about, corner.about) - plane.offset_about);
  if (is_sure(guess)) return counted(&StageTally::interval, &tally, to_sign(guess));
  if (corner.exact < 0) {
    EnclosedPoint exactly = made_exactly(corner);
    corner.about = exactly.about;
    corner.exact = static_cast<std::int32_t>(exact_.size());
    exact_.push_back(std::move(exactly.exact));
  }
  return counted(&StageTally::exact, &tally, plane.height(exact_[static_cast<std::size_t>(corner.exact)]).sign());
}

Sign CutPolygons::sign_at(std::uint32_t corner) {
  Corner& of = corners_[corner];
  if (of.made == Made::point) return sign_at(of.mesh, of.by[0]);
  KnownSide& known = signs_[corner];
  if (known.plane != last()) {
    ++cost_.probes;
    StageTally tally;
    known = {last(), side_of(of, tally)};
    cost_.exact += tally.exact;
  }
  return known.sign;
}

Sign CutPolygons::sign_at(std::size_t mesh, std::uint32_t point) {
  KnownSide& known = point_signs_[mesh][point];
  if (known.plane != last()) {
    ++cost_.probes;
    StageTally tally;
    known = {last(), last_seen_by(mesh).side_of(meshes_[mesh]->mesh().points()[point], &tally)};
    cost_.exact += tally.exact;
  }
  return known.sign;
}

CutPolygons::Sides CutPolygons::sides_of(const CutPolygon& polygon) {
  Sides sides;
  for (std::uint32_t k = 0; k < polygon.size; ++k) sides.include(sign_at(ring_[polygon.begin + k].corner));
  return sides;
}

// The part of a polygon on one side, which has points on both. corner_on(edge): a corner where that edge meets the plane.
template <class CornerOn>
CutPolygon CutPolygons::clipped(const CutPolygon& polygon, Sign side, const CornerOn& corner_on) {
  ++cost_.iterations;
  CutPolygon result{polygon.of, static_cast<std::uint32_t>(ring_.size()), 0};
  for (std::uint32_t k = 0; k < polygon.size; ++k) {
    const RingCorner here = ring_[polygon.begin + k], next = ring_[polygon.begin + (k + 1) % polygon.size];
    const Sign sign = sign_at(here.corner), sign_next = sign_at(next.corner);
    const bool leaves = sign_next != Sign::zero && sign_next != side;
    if (sign == side || sign == Sign::zero) {
      ring_.push_back({here.corner, sign == Sign::zero && leaves ? last() : here.edge});
    }
    if (sign == Sign::zero || sign_next == Sign::zero || sign == sign_next) continue;
    const std::uint32_t made = corner_on(here.edge);
    signs_[made] = {last(), Sign::zero};
    ring_.push_back({made, leaves ? last() : here.edge});
  }
  result.size = static_cast<std::uint32_t>(ring_.size()) - result.begin;
  return result;
}

// ---- Parts of meshes.

template <class OfTriangle>
void CutPolygons::open(std::size_t mesh, std::size_t leaf, const OfTriangle& of_triangle) {
  const Mesh& of = meshes_[mesh]->mesh();
  const auto [first, end] = of.tree().triangles(leaf);
  for (std::uint32_t t = first; t < end; ++t) {
    const auto at = [&](std::size_t k) { return of.points()[of.triangles()[t][k]]; };
    if (of.has_needles() && are_collinear(at(0), at(1), at(2))) continue;
    of_triangle(CutPolygon{t, 0, CutPolygon::triangle});
  }
}

CutPolygonList CutPolygons::opened(std::size_t mesh, const CutPolygonList& parts) {
  const MeshTree& tree = meshes_[mesh]->mesh().tree();
  CutPolygonList result, waiting = parts;
  while (!waiting.empty()) {
    const CutPolygon part = waiting.back();
    waiting.pop_back();
    if (!part.is_node()) {
      result.push_back(part);
    } else if (tree.is_leaf(part.of)) {
      open(mesh, part.of, [&](const CutPolygon& made) { result.push_back(made); });
    } else {
      for (const std::uint32_t k : {0u, 1u}) waiting.push_back({2 * part.of + k});
    }
  }
  return result;
}

std::array<CutPolygonList, 2> CutPolygons::split(std::size_t mesh, const CutPolygonList& parts) {
  const MeshTree& tree = meshes_[mesh]->mesh().tree();
  std::array<CutPolygonList, 2> sides;
  CutPolygonList waiting;
  for (const CutPolygon& part : parts) {
    if (!part.is_node()) {
      split_polygon(mesh, part, sides);
      continue;
    }
    const PlacedPlane& seen = last_seen_by(mesh);
    waiting.push_back(part);
    while (!waiting.empty()) {
      const CutPolygon node = waiting.back();
      waiting.pop_back();
      ++cost_.probes;
      const Guess side = seen.side_of(tree.box(node.of));
      if (is_sure(side)) {
        sides[side == Guess::positive ? 0 : 1].push_back(node);
      } else if (tree.is_leaf(node.of)) {
        open(mesh, node.of, [&](const CutPolygon& made) { split_polygon(mesh, made, sides); });
      } else {
        for (const std::uint32_t k : {0u, 1u}) waiting.push_back({2 * node.of + k});
      }
    }
  }
  return sides;
}

void CutPolygons::split_polygon(std::size_t mesh, const CutPolygon& part, std::array<CutPolygonList, 2>& sides) {
  const Mesh::Triangle& t = meshes_[mesh]->mesh().triangles()[part.of];
  Sides has;
  if (!part.is_triangle()) {
    has = sides_of(part);
  } else {
    for (const std::uint32_t point : t) has.include(sign_at(mesh, point));
  }
  if (!has.above || !has.below) {
    if (has.above || has.below) sides[has.above ? 0 : 1].push_back(part);
    return;
  }
  CutPolygon whole = part;
  if (part.is_triangle()) {
    whole = {part.of, static_cast<std::uint32_t>(ring_.size()), 3};
    for (std::size_t k = 0; k < 3; ++k) {
      ring_.push_back({add_corner(Made::point, mesh, {t[k], 0, 0}), -1 - static_cast<std::int32_t>(k)});
    }
  }
  std::array<RingCorner, 2> made{};  // two edges are crossed at most, once for both sides
  std::size_t count = 0;
  const auto corner_on = [&](std::int32_t edge) {
    for (std::size_t k = 0; k < count; ++k) {
      if (made[k].edge == edge) return made[k].corner;
    }
    const auto plane = static_cast<std::uint32_t>(last());
    const auto k = static_cast<std::size_t>(-1 - edge);
    made[count] = {edge >= 0 ? add_corner(Made::on_triangle, mesh, {part.of, static_cast<std::uint32_t>(edge), plane})
                             : add_corner(Made::on_edge, mesh, {t[k], t[(k + 1) % 3], plane}),
                   edge};
    return made[count++].corner;
  };
  sides[0].push_back(clipped(whole, Sign::positive, corner_on));
  sides[1].push_back(clipped(whole, Sign::negative, corner_on));
}

// ---- Cells.

CutPolygonList CutPolygons::add_box(const Box3& box) {
  std::array<std::uint32_t, 6> planes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    planes[2 * axis] = static_cast<std::uint32_t>(add_plane(ExactPlane::across_axis(axis, box.low[axis])));
    planes[2 * axis + 1] = static_cast<std::uint32_t>(add_plane(ExactPlane::across_axis(axis, box.high[axis])));
  }
  const auto first = static_cast<std::uint32_t>(corners_.size());
  for (std::uint32_t k = 0; k < 8; ++k) {
    add_corner(Made::by_planes, 0, {planes[k & 1], planes[2 + (k >> 1 & 1)], planes[4 + (k >> 2 & 1)]});
  }
  // The corners of a facet in a cycle, counter-clockwise as seen from outside; each edge is on the plane that both its
  // ends are on.
  CutPolygonList facets;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t i = 1u << (axis + 1) % 3, j = 1u << (axis + 2) % 3;
    const auto u = [&](std::size_t end) { return static_cast<std::int32_t>(planes[2 * ((axis + 1) % 3) + end]); };
    const auto v = [&](std::size_t end) { return static_cast<std::int32_t>(planes[2 * ((axis + 2) % 3) + end]); };
    for (const std::uint32_t end : {0u, 1u}) {
      const std::uint32_t at = first + (end << axis);
      const std::array<RingCorner, 4> up{RingCorner{at, v(0)}, {at + i, u(1)}, {at + i + j, v(1)}, {at + j, u(0)}},
          down{RingCorner{at, u(0)}, {at + j, v(1)}, {at + i + j, u(1)}, {at + i, v(0)}};
      facets.push_back({planes[2 * axis + end], static_cast<std::uint32_t>(ring_.size()), 4});
      const auto& ring = end == 1 ? up : down;
      ring_.insert(ring_.end(), ring.begin(), ring.end());
    }
  }
  return facets;
}

bool CutPolygons::goes_through(const CutPolygonList& facets) {
  bool above = false, below = false;
  for (const CutPolygon& facet : facets) {
    const Sides has = sides_of(facet);
    above |= has.above;
    below |= has.below;
  }
  return above && below;
}

CutPolygonList CutPolygons::cut_cell(const CutPolygonList& facets, Sign side) {
  struct Edge {
    std::uint32_t from, to;
    std::int32_t on;
  };
  CutPolygonList result;
  std::vector<Edge> rim;  // edges of the new facet
  for (const CutPolygon& facet : facets) {
    const auto [above, below] = sides_of(facet);
    if (!(side == Sign::positive ? above : below)) continue;
    CutPolygon kept = facet;
    if (above && below) {
      // An edge is one of two facets, and both sides have its corner.
      kept = clipped(facet, side, [&](std::int32_t edge) {
        const auto on = static_cast<std::uint32_t>(edge);
        const std::uint32_t low = std::min(facet.of, on), high = std::max(facet.of, on);
        for (const CellCorner& known : on_last_) {
          if (known.low == low && known.high == high) return known.corner;
        }
        const std::uint32_t made = add_corner(Made::by_planes, 0, {low, high, static_cast<std::uint32_t>(last())});
        on_last_.push_back({low, high, made});
        return made;
      });
    }
    result.push_back(kept);
    for (std::uint32_t k = 0; k < kept.size; ++k) {
      const std::uint32_t here = ring_[kept.begin + k].corner, next = ring_[kept.begin + (k + 1) % kept.size].corner;
      if (sign_at(here) == Sign::zero && sign_at(next) == Sign::zero) {
        rim.push_back({next, here, static_cast<std::int32_t>(facet.of)});
      }
    }
  }
  CutPolygon cap{static_cast<std::uint32_t>(last()), static_cast<std::uint32_t>(ring_.size()), 0};
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
  const Corner &p = corners_[i], &q = corners_[j];
  const auto are_apart = [](const Interval& x, const Interval& y) { return x.high < y.low || y.high < x.low; };
  if (are_apart(p.about.x, q.about.x) || are_apart(p.about.y, q.about.y) || are_apart(p.about.z, q.about.z)) {
    return false;
  }
  const ExactPoint3 u = exact(i), v = exact(j);
  for (std::size_t c = 0; c < 3; ++c) {
    if (!(u[c] * v.denominator == v[c] * u.denominator)) return false;
  }
  return true;
}

}  // namespace sunder::solid
