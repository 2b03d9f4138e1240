// The half-planes of the edges of a polygon with one ring: of each edge the side where the polygon is.
// Also called: inner half-planes of a polygon; H-representation, where it is convex.
#pragma once

#include <sunder/base/error.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/predicate/line/constraints.h>

#include <cstdint>
#include <span>

namespace sunder::planar {

// A view, numbered as the edges are. Which side is inside is found exactly, from the turn at the lexicographically
// first vertex; so it is right for a simple polygon. For one that is not simple the half-planes are well-defined, but
// mean nothing: a pentagram's have a common part, and yet it has no kernel.
class PolygonSides {
 public:
  using Half = LeftOf;

  // Keeps a reference. Throws Error bad_shape where there are several rings (a polygon with a hole has no kernel); with
  // the place "vertex 7" where it equals the next one, and where the ring turns back at the first vertex: none of these
  // is simple (polygon_simple tells, for all that are not).
  explicit PolygonSides(const Polygon& polygon);

  std::uint32_t size() const { return static_cast<std::uint32_t>(vertices_.size()); }
  LeftOf operator[](std::uint32_t k) const {
    const Point2 &a = vertices_[k], &b = vertices_[k + 1 == vertices_.size() ? 0 : k + 1];
    return clockwise_ ? LeftOf{b, a} : LeftOf{a, b};
  }

  bool clockwise() const { return clockwise_; }
  std::span<const Point2> vertices() const { return vertices_; }

 private:
  std::span<const Point2> vertices_;
  bool clockwise_ = false;
};

}  // namespace sunder::planar
