// The surface of a convex polyhedron as half-edges: from each facet over an edge to the next, and around each vertex.
// Also called: doubly connected edge list (DCEL); rotation system.
//
// A half-edge is a side of an edge: it goes along its facet, counter-clockwise seen from outside, and its twin goes
// back along the facet beyond. Half-edges are numbered facet by facet, as the facets' vertices are: half-edge
// facet_begin[f] + k starts at the k-th vertex of facet f. So half of a facet, or of the edges at a vertex, is a step.
#pragma once

#include <sunder/base/contract.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

class ConvexPolyhedron;

struct HalfEdges {
  static constexpr std::size_t slot = 3;  // see solid/represent/of.h

  // Requires three vertices or more. Cost: O(n).
  static HalfEdges make(const ConvexPolyhedron& body);

  // Of the polyhedron, by facet; it has to outlive this.
  std::span<const std::uint32_t> facet_begin, origin;

  std::vector<std::uint32_t> twin, facet;  // by half-edge
  std::vector<std::uint32_t> begin;        // those that start at v: out[begin[v] .. begin[v + 1]),
  std::vector<std::uint32_t> out;          // counter-clockwise seen from outside
  std::vector<std::uint32_t> around;       // by half-edge: its place there, from 0 on

  std::uint32_t facet_size(std::uint32_t f) const { return facet_begin[f + 1] - facet_begin[f]; }
  std::uint32_t degree(std::uint32_t v) const { return begin[v + 1] - begin[v]; }

  // The one k places further along its facet, or around the vertex where it starts. Requires k < the size, the degree.
  std::uint32_t along(std::uint32_t e, std::uint32_t k) const {
    const std::uint32_t first = facet_begin[facet[e]], end = facet_begin[facet[e] + 1];
    SUNDER_REQUIRE(k < end - first);
    return k < end - e ? e + k : e + k - (end - first);
  }
  std::uint32_t turned(std::uint32_t e, std::uint32_t k) const {
    const std::uint32_t v = origin[e], n = degree(v), at = around[e];
    SUNDER_REQUIRE(k < n);
    return out[begin[v] + (k < n - at ? at + k : at + k - n)];
  }

  std::uint32_t tip(std::uint32_t e) const { return origin[twin[e]]; }

  std::size_t memory() const {  // bytes
    return sizeof(*this) +
           (twin.capacity() + facet.capacity() + begin.capacity() + out.capacity() + around.capacity()) *
               sizeof(twin[0]);
  }
};

}  // namespace sunder::solid
