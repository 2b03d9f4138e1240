// Floating-point searches for a vertex far along a direction. They propose; exact comparisons dispose
// (solid/pair/extreme_vertex.h).
#pragma once

#include <sunder/solid/object/search_graph.h>

#include <cmath>
#include <cstdint>

namespace sunder::solid {

// Goes from the block at `start` to ever better neighbours until none is better in floating point: the best neighbour
// each time, of equals the first. Returns the place of the last block. Adds the vertices it looks at to `probes`. Ends,
// because the value grows strictly.
inline std::uint32_t walk(const SearchGraph& graph, const Point3& direction, std::uint32_t start,
                          std::uint32_t& probes) {
  std::uint32_t at = start;
  VertexBlock block = graph.block(at);
  const Point3 p = block.at();
  double best = direction.x * p.x + direction.y * p.y + direction.z * p.z;
  ++probes;
  while (true) {
    const std::uint32_t count = block.count();
    const double *x = block.x(), *y = block.y(), *z = block.z();
    probes += count;
    std::uint32_t winner = count;
    for (std::uint32_t j = 0; j < count; ++j) {
      const double value = direction.x * x[j] + direction.y * y[j] + direction.z * z[j];
      if (value > best) {
        best = value;
        winner = j;
      }
    }
    if (winner == count) return at;
    at = block.place(winner);
    block = graph.block(at);
  }
}

// The cell of the direction table: the place of a vertex extreme along a direction nearby. Requires a table. Any
// direction will do, even one that is zero or not finite.
inline std::uint32_t table_start(const SearchGraph& graph, const Point3& direction) {
  const double ax = std::fabs(direction.x), ay = std::fabs(direction.y), az = std::fabs(direction.z);
  std::uint32_t face;
  double largest, u, v;
  if (ax >= ay && ax >= az) {
    face = direction.x < 0 ? 1 : 0;
    largest = ax;
    u = direction.y;
    v = direction.z;
  } else if (ay >= az) {
    face = direction.y < 0 ? 3 : 2;
    largest = ay;
    u = direction.x;
    v = direction.z;
  } else {
    face = direction.z < 0 ? 5 : 4;
    largest = az;
    u = direction.x;
    v = direction.y;
  }
  const double side = graph.side;
  const double scale = side / 2 / largest;
  const double column = u * scale + side / 2;
  const double row = v * scale + side / 2;
  if (!(column >= 0 && row >= 0 && column <= side && row <= side)) return graph.table[0];
  const std::uint32_t last = graph.side - 1;
  const std::uint32_t c = std::min(static_cast<std::uint32_t>(column), last);
  const std::uint32_t r = std::min(static_cast<std::uint32_t>(row), last);
  return graph.table[(face * graph.side + r) * graph.side + c];
}

// The first vertex that is furthest in floating point, reading them all. Requires few vertices.
inline std::uint32_t furthest_of_few(const SearchGraph& graph, const Point3& direction, std::uint32_t& probes) {
  const std::uint32_t n = graph.padded;
  const double* x = graph.all.data();
  const double* y = x + n;
  const double* z = y + n;
  double value[SearchGraph::few];
  for (std::uint32_t i = 0; i < n; ++i) value[i] = direction.x * x[i] + direction.y * y[i] + direction.z * z[i];
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < n; ++i) {
    if (value[i] > value[best]) best = i;
  }
  probes += static_cast<std::uint32_t>(graph.vertices.size());
  return best;
}

// Where a search along the direction begins, for furthest_from; asks for the memory that it will read.
inline std::uint32_t search_start(const SearchGraph& graph, const Point3& direction) {
  if (graph.padded != 0) return 0;
  const std::uint32_t start = table_start(graph, direction);
  const double* words = graph.blocks.data() + start;
  __builtin_prefetch(words);
  __builtin_prefetch(words + 8);
  __builtin_prefetch(words + 16);
  __builtin_prefetch(words + 24);
  return start;
}

// A vertex that is furthest along the direction as far as floating point can tell. `start` is search_start().
inline std::uint32_t furthest_from(const SearchGraph& graph, const Point3& direction, std::uint32_t start,
                                   std::uint32_t& probes) {
  if (graph.padded != 0) return furthest_of_few(graph, direction, probes);
  return graph.block(walk(graph, direction, start, probes)).vertex();
}

inline std::uint32_t furthest(const SearchGraph& graph, const Point3& direction, std::uint32_t& probes) {
  return furthest_from(graph, direction, search_start(graph, direction), probes);
}

}  // namespace sunder::solid
