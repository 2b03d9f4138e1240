// Floating-point searches for a vertex far along a direction. They propose; exact comparisons dispose
// (solid/search/extreme_vertex.h).
// Also called: hill climbing; support mapping.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/solid/object/search_graph.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sunder::solid {

// The greatest of the values direction . (x[j], y[j], z[j]), j < count. Requires count to be a positive
// multiple of four. Does not tell which it is: so the processor need not wait for the answer before it goes on, as long
// as it guesses well whether the value is looked at (see walk).
inline double greatest_along(const Point3& direction, const double* x, const double* y, const double* z,
                             std::uint32_t count) {
  const auto values = [&](std::uint32_t j) {
    return direction.x * lanes_at(x + j) + direction.y * lanes_at(y + j) + direction.z * lanes_at(z + j);
  };
  Lanes best = values(0), other = values(2);
  for (std::uint32_t j = 4; j < count; j += 4) {
    best = greater_of(best, values(j));
    other = greater_of(other, values(j + 2));
  }
  return greater_lane(greater_of(best, other));
}

// The first j < count of which direction . (x[j], y[j], z[j]) is `value`, else count.
inline std::uint32_t first_with_value(const Point3& direction, const double* x, const double* y, const double* z,
                                      std::uint32_t count, double value) {
  std::uint32_t j = 0;
  while (j < count && direction.x * x[j] + direction.y * y[j] + direction.z * z[j] != value) ++j;
  return j;
}

// What a walk may cost: beyond that a hierarchy is faster (hierarchy_walk.h).
inline constexpr std::uint32_t most_steps = 8;    // from block to block
inline constexpr std::uint32_t most_around = 32;  // neighbours of a vertex that are looked at

struct Walk {
  std::uint32_t place;  // of the last block
  bool has_ended;       // none of its neighbours is better in floating point; else the walk cost too much
  std::uint64_t steps;
};

// Goes from the block at `start` to ever better neighbours until none is better in floating point: the best neighbour
// each time, of equals the first. Adds the vertices it looks at to `probes`. most: steps.
inline Walk walk(const SearchGraph& graph, const Point3& direction, std::uint32_t start, std::uint64_t& probes,
                 std::uint64_t most = most_steps) {
  std::uint32_t at = start;
  VertexBlock block = graph.block(at);
  const Point3 p = block.at();
  double best = direction.x * p.x + direction.y * p.y + direction.z * p.z;
  ++probes;
  std::uint64_t step = 0;
  for (; block.count() <= most_around; ++step) {
    if (block.count() == 0) return {at, true, step};
    const double *x = block.x(), *y = block.y(), *z = block.z();
    probes += block.count();
    const double greatest = greatest_along(direction, x, y, z, block.padded());
    if (!(greatest > best)) return {at, true, step};
    if (step == most) break;
    const std::uint32_t j = first_with_value(direction, x, y, z, block.count(), greatest);
    if (j == block.count()) return {at, true, step};  // only if lanes and single doubles were compiled to differ
    best = greatest;
    at = block.place(j);
    block = graph.block(at);
  }
  return {at, false, step};
}

// The cell of the direction table: the place of a vertex extreme along a direction nearby. Requires a table. Any
// direction will do, even one that is zero or not finite.
inline std::uint32_t table_start(const SearchGraph& graph, const Point3& direction) {
  const double scale = 1 / (std::fabs(direction.x) + std::fabs(direction.y) + std::fabs(direction.z));
  const Lanes xy = Lanes{direction.x, direction.y} * scale;
  const Lanes beyond = 1 - absolute(swapped(xy));
  const Lanes turned_out = xy < 0 ? -beyond : beyond;
  const Lanes z{direction.z, direction.z};
  const Lanes uv = z < 0 ? turned_out : xy;
  const double half = graph.side * 0.5;
  const Lanes cell = uv * half + half;
  const double column = cell[0], row = cell[1];
  if (!(column >= 0 && row >= 0 && column <= graph.side && row <= graph.side)) return graph.table[0];
  const std::uint32_t last = graph.side - 1;
  const std::uint32_t c = std::min(static_cast<std::uint32_t>(column), last);
  const std::uint32_t r = std::min(static_cast<std::uint32_t>(row), last);
  return graph.table[r * graph.side + c];
}

// The first vertex that is furthest in floating point, reading them all. Requires few vertices.
inline std::uint32_t furthest_of_few(const SearchGraph& graph, const Point3& direction, std::uint64_t& probes) {
  const std::uint32_t n = graph.padded;
  const double* x = graph.all.data();
  const double* y = x + n;
  const double* z = y + n;
  Lanes values[SearchGraph::few / 2];
  const auto value = [&](std::uint32_t i) {
    return direction.x * lanes_at(x + i) + direction.y * lanes_at(y + i) + direction.z * lanes_at(z + i);
  };
  for (std::uint32_t i = 0; i < n; i += 4) {
    values[i / 2] = value(i);
    values[i / 2 + 1] = value(i + 2);
  }
  probes += static_cast<std::uint32_t>(graph.vertices.size());
  const std::uint32_t first = first_of_greatest(values, n / 2);
  return first < graph.vertices.size() ? first : 0;  // past the end where values are not numbers
}

// Where a search along the direction begins; asks for the memory that it will read.
inline std::uint32_t search_start(const SearchGraph& graph, const Point3& direction) {
  if (graph.padded != 0 || graph.is_slow) return 0;
  const std::uint32_t start = table_start(graph, direction);
  const double* words = graph.blocks.data() + start;
  __builtin_prefetch(words);
  __builtin_prefetch(words + 8);
  __builtin_prefetch(words + 16);
  __builtin_prefetch(words + 24);
  return start;
}

}  // namespace sunder::solid
