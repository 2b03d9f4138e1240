// Parts of two placed meshes, and of convex cells, that planes cut. Exact.
// Also called: clipping of polygons (Sutherland and Hodgman); splitting of a convex polyhedron by a plane.
//
// A part of a mesh is all below a node of its tree, as long as no plane goes through the node's box; a triangle; or a
// convex polygon that planes have left of one. A corner is named by what makes it, and enclosed in intervals, which decide
// most signs. It is computed exactly, from what makes it, only where they do not: so its numbers do not grow with the number
// of cuts before.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/predicate/exact_plane.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/mesh/placed_plane.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace sunder::solid {

// A corner, and what the edge to the next one lies on beside the polygon's own plane: the plane of that number, or,
// below zero, an edge of the triangle: -1 the first.
struct RingCorner {
  std::uint32_t corner;
  std::int32_t edge;
};

// `of`: of a facet of a cell its plane; of a part of a mesh its triangle, or the node of its tree.
struct CutPolygon {
  std::uint32_t of = 0, begin = 0, size = node;  // else a ring: ring() tells it

  static constexpr std::uint32_t node = 0, triangle = 1;  // sizes of those that have no ring
  bool is_node() const { return size == node; }
  bool is_triangle() const { return size == triangle; }
};
using CutPolygonList = std::vector<CutPolygon>;

// The plane through a triangle of a mesh.
struct TriangleNumber {
  std::size_t mesh = 0;
  std::uint32_t triangle = 0;
};

class CutPolygons {
 public:
  // Keeps references to both.
  CutPolygons(const PlacedMesh& a, const PlacedMesh& b);

  // Planes are numbered. All is cut by the last one.
  std::int32_t add_plane(ExactPlane plane);
  std::int32_t add_plane(const TriangleNumber& through);
  void remove_plane();
  // Six planes, and the facets between them.
  CutPolygonList add_box(const Box3& box);

  const Point3& near(std::uint32_t corner) const { return corners_[corner].near; }  // about
  ExactPoint3 exact(std::uint32_t corner) const;
  const ExactPlane& plane(std::int32_t k) const { return planes_[static_cast<std::size_t>(k)]; }
  std::span<const RingCorner> ring(const CutPolygon& polygon) const {
    return std::span(ring_).subspan(polygon.begin, polygon.size);
  }
  // probes: comparisons of a corner, or of a box, with a plane; iterations: polygons that were clipped
  const Cost& cost() const { return cost_; }

  // Triangles instead of nodes. Those without area are left out here, and by split().
  CutPolygonList opened(std::size_t mesh, const CutPolygonList& parts);
  // The parts above the last plane, and those below. What lies in the plane is in neither.
  std::array<CutPolygonList, 2> split(std::size_t mesh, const CutPolygonList& parts);
  // Has a cell points on both sides?
  bool goes_through(const CutPolygonList& facets);
  // The facets of the part of a convex cell on one side. Nothing, where the plane does not go through the cell.
  CutPolygonList cut_cell(const CutPolygonList& facets, Sign side);

 private:
  enum class Made : std::uint8_t { point, on_edge, on_triangle, by_planes };
  struct Corner {
    Vector3<Interval> about;  // of all but points of meshes
    Point3 near;
    Made made;
    std::uint8_t mesh = 0;
    std::int32_t exact = -1;            // where it is known: in exact_
    std::array<std::uint32_t, 3> by{};  // a point; two points, a plane; a triangle, two planes; three planes
  };
  struct KnownSide {
    std::int32_t plane = -1;
    Sign sign = Sign::zero;
  };
  struct Sides {
    bool above = false, below = false;
    void include(Sign sign) {
      above |= sign == Sign::positive;
      below |= sign == Sign::negative;
    }
  };

  std::int32_t last() const { return static_cast<std::int32_t>(planes_.size()) - 1; }
  std::uint32_t add_corner(Made made, std::size_t mesh, const std::array<std::uint32_t, 3>& by);
  std::optional<Vector3<Interval>> enclosure_of(const Corner& corner);
  EnclosedPoint made_exactly(const Corner& corner) const;
  const ExactPlane& plane_through(std::size_t mesh, std::uint32_t triangle) const;

  const PlacedPlane& last_seen_by(std::size_t mesh);
  bool is_on_last(const Corner& corner) const;
  Sign side_of(Corner& corner, StageTally& tally);
  Sign sign_at(std::uint32_t corner);
  Sign sign_at(std::size_t mesh, std::uint32_t point);
  Sides sides_of(const CutPolygon& polygon);
  template <class CornerOn>
  CutPolygon clipped(const CutPolygon& polygon, Sign side, const CornerOn& corner_on);
  void split_polygon(std::size_t mesh, const CutPolygon& part, std::array<CutPolygonList, 2>& sides);
  template <class OfTriangle>
  void open(std::size_t mesh, std::size_t leaf, const OfTriangle& of_triangle);
  bool are_equal(std::uint32_t i, std::uint32_t j) const;

  std::array<const PlacedMesh*, 2> meshes_;
  std::array<std::vector<KnownSide>, 2> point_signs_;  // of each point of a mesh, as below
  std::vector<Corner> corners_;
  std::vector<ExactPoint3> exact_;
  std::vector<KnownSide> signs_;  // of each corner the side of the plane that it was compared with last
  std::vector<RingCorner> ring_;
  std::vector<ExactPlane> planes_;
  std::optional<TriangleNumber> last_through_;
  std::array<std::optional<PlacedPlane>, 2> last_seen_;  // the last plane, as the meshes see it
  mutable std::array<std::unordered_map<std::uint32_t, ExactPlane>, 2> triangle_planes_;
  struct CellCorner {
    std::uint32_t low, high, corner;  // on two planes and the last one
  };
  std::vector<CellCorner> on_last_;
  double size_ = 0;
  Cost cost_;
};

}  // namespace sunder::solid
