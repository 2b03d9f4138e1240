// A convex polyhedron: the exact convex hull of any finite, non-empty set of points of space.
// Also called: convex polytope in three dimensions.
#pragma once

#include <sunder/base/error.h>
#include <sunder/base/lazy_slots.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/hull/convex_hull.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace sunder::solid {

struct SearchGraph;  // its vertices and edges as searches read them; see solid/object/search_graph.h

// Immutable, and cheap to copy (copies share one block of memory); any number of threads may use one at once.
//
// Results of dimension 0 to 3 are all allowed: a point, a segment, a flat polygon and a body are convex polyhedra.
// What one might assume and does not hold: the vertices are not in the order of the input (source() tells), and a
// facet may have any number of vertices.
class ConvexPolyhedron {
 public:
  // The hull of the points, in O(n log n) on inputs seen in practice (see solid/hull/convex_hull.h).
  // Throws Error: bad_shape without points, bad_value naming the first point that is not finite.
  explicit ConvexPolyhedron(std::span<const Point3> points);

  // 0: a point, 1: a segment, 2: a flat polygon, 3: a body with an interior.
  int dimension() const;

  // The extreme points, each once. Certificates name vertices by their position here.
  std::span<const Point3> vertices() const;

  // For each vertex, its index among the points that the polyhedron was made of.
  std::span<const std::uint32_t> source() const;

  // The other ends of the edges at a vertex, counter-clockwise seen from outside. Requires v < vertices().size().
  std::span<const std::uint32_t> neighbours(std::uint32_t v) const;

  // Maximal facets, each the cycle of its vertices, counter-clockwise seen from outside. A flat polygon has two.
  std::uint32_t facet_count() const;
  std::span<const std::uint32_t> facet(std::uint32_t f) const;

  // All of them at once: facet f is facet_vertices()[facet_begin()[f] .. facet_begin()[f + 1]).
  std::span<const std::uint32_t> facet_begin() const;
  std::span<const std::uint32_t> facet_vertices() const;

  // The smallest and the largest coordinates.
  std::array<Point3, 2> box() const;

  // Part of the object, and not one of the representations that are made on demand: most queries read it, and nothing
  // else.
  const SearchGraph& search_graph() const;

  // Where its representations are kept; see solid/represent/of.h.
  const LazySlots& slots() const;

  // Bytes, without representations.
  std::size_t memory() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace sunder::solid
