// What the searches walk on: the vertex graph of a convex polyhedron, laid out for the memory cache.
//
// A step of a search at vertex v reads v's neighbours' coordinates, which lie side by side, and goes to the best: no
// indirection but one. A table over directions gives a start near the goal. For bodies of few vertices, reading them
// all is faster than walking: `all` holds them coordinate by coordinate.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/hull/convex_hull.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

struct SearchGraph {
  // Bodies with at most this many vertices are read whole.
  static constexpr std::uint32_t few = 32;

  std::vector<Point3> vertices;

  // The neighbours of v, counter-clockwise: vertex numbers neighbours[begin[v] .. begin[v + 1]). Their coordinates:
  // with k of them, k times x, then y, then z, from coordinates[3 begin[v]].
  std::vector<std::uint32_t> begin{0};
  std::vector<std::uint32_t> neighbours;
  std::vector<double> coordinates;

  // Empty with few vertices. Else a cube of directions, each of its six faces (+x -x +y -y +z -z) cut into side x side
  // cells row by row; the entry is a vertex that is extreme along the direction to the middle of the cell.
  std::uint32_t side = 0;
  std::vector<std::uint32_t> table;

  // Empty with many vertices. Else x of all, then y, then z, padded with the first vertex to a multiple of four.
  std::uint32_t padded = 0;
  std::vector<double> all;

  Point3 middle;     // of the box, rounded: a place to aim at, nothing more
  SizeRange sizes;   // of the coordinates
  Point3 low, high;  // the box
};

SearchGraph make_search_graph(std::span<const Point3> vertices, std::span<const std::uint32_t> neighbour_begin,
                              std::span<const std::uint32_t> neighbours);

}  // namespace sunder::solid
