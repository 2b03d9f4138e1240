// How far a body surely reaches along a direction, in doubles. f: a direction as the body sees it, rounded, of which a
// component is at most 9.1 in size and within 28 u of the exact one; u = 2^-53. S: the greatest coordinate. Derived in
// kept_partings.cpp.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/search/search_vector.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace sunder::solid {

inline constexpr double sure_rounding = 1024 * 0x1p-53;

// Are all neighbours of this block's vertex surely further along f?
inline bool is_surely_least(const VertexBlock& block, const Point3& f, double error) {
  const Point3 at = block.at();
  const double *x = block.x(), *y = block.y(), *z = block.z();
  LanesMask all{-1, -1};
  for (std::uint32_t j = 0; j < block.padded(); j += 2) {
    all &= f.x * (lanes_at(x + j) - at.x) + f.y * (lanes_at(y + j) - at.y) + f.z * (lanes_at(z + j) - at.z) > error;
  }
  return (all[0] & all[1]) != 0;
}

// The least of f w of all vertices w, where it is sure which vertex that is, or all are looked at; else minus infinity.
// Rounded: within 84 u S for f and 83 u S for the products. Looked for from `near` on, which becomes that vertex.
// Requires near < number of vertices.
inline double surely_least_along(const SearchGraph& graph, const Point3& f, std::uint32_t& near) {
  constexpr double unsure = -std::numeric_limits<double>::infinity();
  if (graph.padded != 0) {
    const double* const x = graph.all.data();
    return -greatest_along(negated(f), x, x + graph.padded, x + 2 * std::size_t{graph.padded}, graph.padded);
  }
  if (graph.is_slow) return unsure;
  std::uint64_t probes = 0;
  const std::uint32_t here = graph.place[near], there = table_start(graph, negated(f));
  const bool is_far = dot(f, graph.block(here).at()) > dot(f, graph.block(there).at());
  const VertexBlock end = graph.block(walk(graph, negated(f), is_far ? there : here, probes).place);
  near = end.vertex();
  // Where all neighbours are further, so are all vertices. A difference is at most 2 S in each component: an error of f
  // costs 168 u S, rounding 280 u S.
  if (!is_surely_least(end, f, sure_rounding * graph.sizes.greatest)) return unsure;
  return dot(f, end.at());
}

}  // namespace sunder::solid
