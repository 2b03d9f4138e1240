// The edges of a set of polygons, numbered over all polygons in turn, and the sides of them that are inside.
//
// Inside of a polygon is what an odd number of its rings encloses (the even-odd rule): inside of the outer ring, not in
// a hole, inside of an island in a hole. Its rings, and each ring by itself, neither cross nor overlap; they may touch
// in points. So each edge has the inside of its polygon on one side.
#pragma once

#include <sunder/near/box_grid.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/planar/object/segments.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

class PolygonEdges {
 public:
  // Keeps the pointers. Cost: linear. Requires fewer than 2^31 edges in all.
  explicit PolygonEdges(std::vector<const Polygon*> polygons);

  std::uint32_t polygon_count() const { return static_cast<std::uint32_t>(polygons_.size()); }
  const Polygon& polygon(std::uint32_t p) const { return *polygons_[p]; }

  const Segments& edges() const { return edges_; }
  std::uint32_t polygon_of(std::uint32_t e) const { return polygon_of_[e]; }
  std::uint32_t in_polygon(std::uint32_t e) const { return e - first_edge_[polygon_of_[e]]; }  // its number there
  std::uint32_t first_edge(std::uint32_t p) const { return first_edge_[p]; }
  std::uint32_t next(std::uint32_t e) const { return e - in_polygon(e) + polygon_of_edge(e).next(in_polygon(e)); }
  std::uint32_t previous(std::uint32_t e) const {
    return e - in_polygon(e) + polygon_of_edge(e).previous(in_polygon(e));
  }

  // Rings, numbered over all polygons in turn too.
  struct Ring {
    std::uint32_t polygon, in_polygon;
  };
  const std::vector<Ring>& rings() const { return rings_; }
  std::uint32_t first_ring(std::uint32_t p) const { return first_ring_[p]; }
  std::vector<Box2> ring_boxes() const;

  // Is the inside of its polygon above the edge, that is, to the left of the way from its first end to its last?
  // Cost of the first question about a polygon: linear for one ring; else as many times linear as rings are nested.
  bool inside_is_above(std::uint32_t e);

 private:
  const Polygon& polygon_of_edge(std::uint32_t e) const { return *polygons_[polygon_of_[e]]; }
  void find_sides(std::uint32_t polygon);

  std::vector<const Polygon*> polygons_;
  std::vector<std::uint32_t> first_edge_, first_ring_;  // of each polygon
  std::vector<std::uint32_t> polygon_of_;
  std::vector<Ring> rings_;
  std::vector<bool> sides_known_;     // of each polygon
  std::vector<bool> inside_is_left_;  // of the edges of each ring, in the ring's direction
  Segments edges_;
};

// Pointers to all of them.
inline std::vector<const Polygon*> pointers_to(std::span<const Polygon> polygons) {
  std::vector<const Polygon*> pointers;
  pointers.reserve(polygons.size());
  for (const Polygon& polygon : polygons) pointers.push_back(&polygon);
  return pointers;
}

Box2 box_of_ring(const Polygon& polygon, std::uint32_t ring);

}  // namespace sunder::planar
