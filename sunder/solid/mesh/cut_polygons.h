// Convex polygons in space that planes cut: parts of triangles, and the facets of convex cells. Exact.
// Also called: clipping of polygons (Sutherland and Hodgman); splitting of a convex polyhedron by a plane.
//
// Corners are kept by number, exactly. One that a cut makes is named by what makes it, and computed from that: so its
// numbers do not grow with the number of cuts before.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/predicate/exact_plane.h>
#include <sunder/predicate/point.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace sunder::solid {

// A corner, and what the edge to the next one lies on beside the polygon's own plane: the plane of that number, or one
// that only the owner knows, below zero.
struct RingCorner {
  std::uint32_t corner;
  std::int32_t edge;
};

// `of`: of a facet its plane; else whatever the owner knows.
struct CutPolygon {
  std::uint32_t of = 0, begin = 0, size = 0;  // a ring: ring() tells it
};
using CutPolygonList = std::vector<CutPolygon>;

class CutPolygons {
 public:
  std::uint32_t add_corner(EnclosedPoint at);
  std::int32_t add_plane(ExactPlane plane);
  CutPolygon add_polygon(std::uint32_t of, std::span<const RingCorner> ring);
  // In the place of the last one.
  void replace_plane(ExactPlane plane);
  // Six planes, and the facets between them.
  CutPolygonList add_box(const Box3& box);

  const EnclosedPoint& corner(std::uint32_t k) const { return corners_[k]; }
  const Point3& near(std::uint32_t corner) const { return near_[corner]; }  // the same, about
  const ExactPlane& plane(std::int32_t k) const { return planes_[static_cast<std::size_t>(k)]; }
  std::size_t corner_count() const { return corners_.size(); }
  std::span<const RingCorner> ring(const CutPolygon& polygon) const {
    return std::span(ring_).subspan(polygon.begin, polygon.size);
  }
  const Cost& cost() const { return cost_; }  // probes: comparisons of a corner with a plane

  // On which sides of a plane a polygon, or any of some, has points.
  std::pair<bool, bool> above_and_below(const CutPolygon& polygon, std::int32_t plane);
  bool goes_through(const CutPolygonList& polygons, std::int32_t plane);

  // The part of a polygon on one side of a plane; requires that it has points on both. corner_on(edge): a corner where
  // that edge of the polygon meets the plane.
  template <class CornerOn>
  CutPolygon clipped(const CutPolygon& polygon, std::int32_t plane, Sign side, const CornerOn& corner_on) {
    CutPolygon result{polygon.of, static_cast<std::uint32_t>(ring_.size()), 0};
    for (std::uint32_t k = 0; k < polygon.size; ++k) {
      const RingCorner here = ring_[polygon.begin + k], next = ring_[polygon.begin + (k + 1) % polygon.size];
      const Sign sign = sign_at(here.corner, plane), sign_next = sign_at(next.corner, plane);
      const bool leaves = sign_next != Sign::zero && sign_next != side;
      if (sign == side || sign == Sign::zero) {
        ring_.push_back({here.corner, sign == Sign::zero && leaves ? plane : here.edge});
      }
      if (sign == Sign::zero || sign_next == Sign::zero || sign == sign_next) continue;
      const std::uint32_t made = corner_on(here.edge);
      signs_[made] = {plane, Sign::zero};
      ring_.push_back({made, leaves ? plane : here.edge});
    }
    result.size = static_cast<std::uint32_t>(ring_.size()) - result.begin;
    return result;
  }

  // The facets of the part of a convex cell on one side of a plane. Edges lie on planes of facets. Nothing, where the plane
  // does not go through the cell.
  CutPolygonList cut_cell(const CutPolygonList& facets, std::int32_t plane, Sign side);

 private:
  struct KnownSide {
    std::int32_t plane;
    Sign sign;
  };

  Sign sign_at(std::uint32_t corner, std::int32_t plane);
  bool are_equal(std::uint32_t i, std::uint32_t j) const;

  std::vector<EnclosedPoint> corners_;
  std::vector<Point3> near_;
  std::vector<KnownSide> signs_;  // of each corner the side of the plane that it was compared with last
  std::vector<RingCorner> ring_;
  std::vector<ExactPlane> planes_;
  Cost cost_;
};

}  // namespace sunder::solid
