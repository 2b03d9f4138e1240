// A convex polyhedron: the exact convex hull of any finite, non-empty set of points of space.
// Also called: convex polytope in three dimensions.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/hull/convex_hull.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace sunder::solid {

struct SearchGraph;     // what searches walk on; see solid/represent/search_graph.h
struct Hierarchy;       // where the search graph is slow; see solid/represent/hierarchy.h
struct Polar;           // facets as vertices; see solid/represent/polar.h
struct PolarHierarchy;  // of that; see solid/represent/polar_hierarchy.h
struct HalfEdges;       // from facet to facet; see solid/represent/half_edges.h
class Drums;            // a stack of cross-sections; see solid/represent/drums.h
enum class DrumsForm : std::uint8_t;
struct FacetGraph;  // what searches along lines walk on; see solid/represent/facet_graph.h

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

  // The smallest and the largest coordinates.
  std::array<Point3, 2> box() const;

  const SearchGraph& search_graph() const;

  // Made on first use, in O(n), and then shared. Requires three vertices or more.
  const Hierarchy& hierarchy() const;

  // Its polar about a point inside (solid/represent/polar.h). Made on first use, in O(n), and then shared.
  // Throws Error: bad_shape if the dimension is not 3.
  const Polar& polar() const;

  // The hierarchy of its polar. Made on first use, in O(n), and then shared. Throws as polar().
  const PolarHierarchy& polar_hierarchy() const;

  // Made on first use, in O(n), and then shared. Requires three vertices or more.
  const HalfEdges& half_edges() const;

  // Its drums, bottom up along z (a body in one level plane along x, or y), in the persistent form. Made on first use,
  // in O(n log n), and then shared.
  const Drums& drums() const;

  // Others. Throws as the constructor of Drums.
  Drums make_drums(const Point3& direction, DrumsForm form) const;

  // Which facets rays go through, and which lie at edges. Made on first use, in O(n log n), and then shared. Requires
  // three vertices or more.
  const FacetGraph& facet_graph() const;

  // Bytes of all that searches walk on, with the hierarchies, which it makes; without polar(), drums(),
  // facet_graph() and half_edges().
  std::size_t memory() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace sunder::solid
