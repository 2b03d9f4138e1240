// Convex polygons: arrays of vertices, counter-clockwise, ready for searches in logarithmic time.
// Also called: convex polytope of the plane, by its vertices (V-representation).
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// Immutable; any number of threads may use it. Closed: its boundary belongs to it.
// C1. Coordinates are finite, and there is at least one vertex.
// C2. The vertices are strictly convex and counter-clockwise: at each the boundary turns left, once around. Two
//     vertices are a segment, one is a point.
// C3. Vertices keep the numbers they were given with, but for what hull_of and mended leave out.
class ConvexPolygon {
 public:
  // These vertices, checked exactly. Throws Error bad_value, "vertex 7: ...", for a number that is not finite;
  // bad_shape, naming the first vertex at which the boundary does not turn left (reflex, collinear, repeated), or
  // saying that the vertices run clockwise or wind about more than once, or that there are none, or 2^31 and more.
  // Cost: linear.
  static ConvexPolygon from_vertices(std::vector<Point2> vertices);

  // The same, but a last vertex that repeats the first one, repeated vertices in a row and collinear ones are left out
  // first, and clockwise ones are turned round. What is not convex even then is refused as above; the index named is
  // that of the vertices given.
  static ConvexPolygon mended(std::span<const Point2> vertices);

  // The exact convex hull of any points, one at least, beginning with the lexicographically first one. Throws Error as
  // from_vertices. Cost: O(n log n). Source: Andrew 1979.
  static ConvexPolygon hull_of(std::span<const Point2> points);

  std::uint32_t size() const { return static_cast<std::uint32_t>(vertices_.size()); }
  const Point2& operator[](std::uint32_t v) const { return vertices_[v]; }
  std::span<const Point2> vertices() const& { return vertices_; }
  std::span<const Point2> vertices() && = delete;  // they would be gone

  // The vertex after v and before it. Edge v goes from v to next(v).
  std::uint32_t next(std::uint32_t v) const { return v + 1 == size() ? 0 : v + 1; }
  std::uint32_t previous(std::uint32_t v) const { return (v == 0 ? size() : v) - 1; }

  // The vertices that are lexicographically first and last. Edges from the first to the last one run to the right, or
  // vertically up; those back run to the left, or vertically down.
  std::uint32_t leftmost() const { return leftmost_; }
  std::uint32_t rightmost() const { return rightmost_; }

  // The sizes of the coordinates, for predicates (see predicate/posed.h).
  const SizeRange& sizes() const { return sizes_; }

 private:
  explicit ConvexPolygon(std::vector<Point2> vertices);  // requires C1 and C2

  std::vector<Point2> vertices_;
  std::uint32_t leftmost_ = 0, rightmost_ = 0;
  SizeRange sizes_;
};

}  // namespace sunder::planar
