// The facets of a convex polyhedron as searches along lines walk on them: which facet a ray from a point o inside goes
// through, from facet to facet; and which facet lies at an edge.
// Also called: dual graph, facet adjacency graph; radial search structure.
//
// The ray from o along y goes through the facet whose vertex of the polar is furthest along y (polar.h): so the search
// is that for an extreme vertex, in the polar's search graph.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/object/search_graph.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace sunder::solid {

class ConvexPolyhedron;

struct FacetGraph {
  static constexpr std::size_t slot = 4;  // see solid/represent/of.h

  // Requires three vertices or more. Cost: O(n) but for sorting.
  static FacetGraph make(const ConvexPolyhedron& body);

  // Of a body with an inside; else meaningless. A frame of its own about a point inside, far from all facets: the box
  // is 2 long along each axis, y = to_one (x - center). The facet n.y = h is the vertex n / h of `facets`. Rounded, and
  // infinite beyond the range: for searches.
  Point3 center, to_one{1, 1, 1};
  SearchGraph facets;

  // Which facet a vertex of `facets` is: they stand along a curve, so that neighbours tend to share cache lines.
  std::vector<std::uint32_t> number;

  // An edge as seen from its facet, which is to the left of it, and goes on from its position there.
  struct Edge {
    std::uint32_t to, facet, position;
  };
  // Those from vertex v: edges[begin[v] .. begin[v + 1]), by `to`.
  std::vector<std::uint32_t> begin;
  std::vector<Edge> edges;

  // Nothing where this is no edge. Cost: O(log degree).
  std::optional<Edge> edge(std::uint32_t from, std::uint32_t to) const;

  // The facet with these three vertices, in the order counter-clockwise from outside, as a hierarchy has it: one of
  // them begins its fan, so that two are an edge. Requires such ones.
  std::uint32_t facet_of(std::uint32_t u, std::uint32_t v, std::uint32_t w) const;

  std::size_t memory() const;  // bytes
};

}  // namespace sunder::solid
