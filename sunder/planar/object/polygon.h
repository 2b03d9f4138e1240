// A polygon with holes: closed rings of vertices, not necessarily simple.
// Also called: polygonal region, multipolygon, area feature; even-odd rule.
#pragma once

#include <sunder/base/error.h>
#include <sunder/planar/object/edge_boxes.h>
#include <sunder/planar/object/segments.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// Immutable. Vertices are numbered over all rings in turn; edge k goes from vertex k to the next of its ring.
// P1. All coordinates are finite, and each ring has at least three vertices.
// P2. A last vertex that repeats its ring's first one, as files have it, is left out; other repetitions stay.
// What one might assume and does not hold: that the first ring is the outer one, or is turned some way.
class Polygon {
 public:
  // Throws Error bad_value, "ring 0, vertex 7: ...", where a coordinate is not finite; bad_shape for no ring, a ring
  // of fewer than three vertices, or 2^31 vertices and more.
  explicit Polygon(std::span<const std::vector<Point2>> rings);

  std::uint32_t size() const { return static_cast<std::uint32_t>(vertices_.size()); }  // of vertices, and of edges
  const std::vector<Point2>& vertices() const { return vertices_; }

  const Box2& box() const { return box_; }                     // the smallest that holds all vertices
  const EdgeBoxes& edge_boxes() const { return edge_boxes_; }  // for searches

  // Is it one ring that turns to one side at each vertex, straight on at none, and goes round once? Exact. Such a ring
  // meets itself nowhere.
  bool strictly_convex() const { return strictly_convex_; }

  std::uint32_t ring_count() const { return static_cast<std::uint32_t>(begin_.size() - 1); }
  std::uint32_t ring_begin(std::uint32_t ring) const { return begin_[ring]; }  // also of ring ring_count(): the end
  std::span<const Point2> ring(std::uint32_t r) const {
    return std::span(vertices_).subspan(begin_[r], begin_[r + 1] - begin_[r]);
  }
  std::uint32_t ring_of(std::uint32_t k) const { return ring_.empty() ? 0 : ring_[k]; }

  // The vertex, or edge, after and before k in its ring.
  std::uint32_t next(std::uint32_t k) const {
    if (ring_.empty()) return k + 1 == size() ? 0 : k + 1;
    return k + 1 == begin_[ring_[k] + 1] ? begin_[ring_[k]] : k + 1;
  }
  std::uint32_t previous(std::uint32_t k) const {
    if (ring_.empty()) return (k == 0 ? size() : k) - 1;
    return (k == begin_[ring_[k]] ? begin_[ring_[k] + 1] : k) - 1;
  }

  Segment edge(std::uint32_t k) const { return {vertices_[k], vertices_[next(k)]}; }  // in the ring's direction

 private:
  std::vector<Point2> vertices_;
  std::vector<std::uint32_t> begin_{0}, ring_;  // ring_ is empty where there is one
  Box2 box_;
  EdgeBoxes edge_boxes_;
  bool strictly_convex_ = false;
};

}  // namespace sunder::planar
