// What the searches walk on: the vertex graph of a convex polyhedron, laid out for the memory cache.
// Also called: vertex adjacency graph, 1-skeleton of a polytope.
//
// A search at vertex v reads one block: v's coordinates, and those of its neighbours side by side. A table over
// directions gives a start near the goal. So a step touches a few neighbouring cache lines, and depends on one load.
// For bodies of few vertices, reading them all is faster than walking: `all` holds them coordinate by coordinate.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/hull/convex_hull.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace sunder::solid {

// One vertex's block, k neighbours, as it lies in SearchGraph::blocks:
//   x y z of the vertex | its number and k | p times x | p times y | p times z | p places of blocks, two in a word
// all in words of 64 bits. The neighbours stand counter-clockwise; p is k rounded up to a multiple of four, and the
// first neighbour stands once more in what is left over, so that loops have no remainder.
class VertexBlock {
 public:
  explicit VertexBlock(const double* words) : words_(words) {}

  static constexpr std::uint32_t words_ahead = 24;  // how far from a block's beginning memory is asked for ahead

  Point3 at() const { return {words_[0], words_[1], words_[2]}; }
  std::uint32_t vertex() const { return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(words_[3])); }
  std::uint32_t count() const { return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(words_[3]) >> 32); }

  std::uint32_t padded() const { return padded(count()); }
  static std::uint32_t padded(std::uint32_t count) { return (count + 3) / 4 * 4; }

  // padded() numbers each.
  const double* x() const { return words_ + 4; }
  const double* y() const { return words_ + 4 + padded(); }
  const double* z() const { return words_ + 4 + 2 * std::size_t{padded()}; }

  // The place of the j-th neighbour's block. Requires j < padded().
  std::uint32_t place(std::uint32_t j) const {
    SUNDER_REQUIRE(j < padded());
    const std::uint64_t pair = std::bit_cast<std::uint64_t>(words_[4 + 3 * std::size_t{padded()} + j / 2]);
    return static_cast<std::uint32_t>(pair >> (j % 2 * 32));
  }

 private:
  const double* words_;
};

struct SearchGraph {
  // Bodies with at most this many vertices are read whole.
  static constexpr std::uint32_t few = 32;

  std::vector<Point3> vertices;

  // The neighbours of v, counter-clockwise: vertex numbers neighbours[begin[v] .. begin[v + 1]).
  std::vector<std::uint32_t> begin{0};
  std::vector<std::uint32_t> neighbours;

  // The block of v starts at blocks[place[v]]. After the last one there are some more words that nothing reads, so that
  // asking for memory ahead stays within.
  std::vector<std::uint32_t> place;
  std::vector<double> blocks;

  VertexBlock block(std::uint32_t at) const { return VertexBlock(blocks.data() + at); }

  // Empty with few vertices, and where is_slow. Else the octahedron of directions, |x| + |y| + |z| = 1, unfolded into
  // the square [-1, 1]^2 and cut into side x side cells row by row: the upper half, z >= 0, is seen from above; the
  // four faces of the lower half are turned outwards about their upper edges. The entry is the place of a vertex that
  // is extreme, as far as doubles tell, along the direction to the middle of the cell; or of one near it, where a walk
  // from the cell before would cost too much (search_graph_walk.h). Source of the map: Engelhardt and Dachsbacher 2008,
  // octahedron environment maps.
  std::uint32_t side = 0;
  std::vector<std::uint32_t> table;

  // Would walks from a table often be long, or at vertices of many neighbours? Then there is none: a search goes down
  // the hierarchy.
  bool is_slow = false;

  // Empty with many vertices. Else x of all, then y, then z, padded with the first vertex to a multiple of four.
  std::uint32_t padded = 0;
  std::vector<double> all;

  Point3 middle;     // of the box, rounded: a place to aim at, nothing more
  SizeRange sizes;   // of the coordinates
  Point3 low, high;  // the box

  std::size_t memory() const {  // bytes
    const auto bytes = [](const auto& of) { return of.capacity() * sizeof(of[0]); };
    return sizeof(*this) + bytes(vertices) + bytes(begin) + bytes(neighbours) + bytes(place) + bytes(blocks) +
           bytes(table) + bytes(all);
  }
};

// Throws Error bad_shape where the blocks have 2^32 words or more: about 10^8 vertices.
// Neighbours: as in SearchGraph.
SearchGraph make_search_graph(std::vector<Point3> vertices, std::vector<std::uint32_t> neighbour_begin,
                              std::vector<std::uint32_t> neighbours);

}  // namespace sunder::solid
