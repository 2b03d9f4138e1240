#include <sunder/base/contract.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/polar.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sunder::solid {

namespace {

// A power of two that brings the length near 1.
double near_one(double low, double high) {
  const double half = high / 2 - low / 2;  // no overflow
  return half > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(half), -1020, 1020)) : 1;
}

void add_edges(FacetGraph& graph, std::size_t vertex_count, std::span<const std::uint32_t> corner_begin,
               std::span<const std::uint32_t> corners) {
  graph.begin.assign(vertex_count + 1, 0);
  for (const std::uint32_t v : corners) ++graph.begin[v + 1];
  for (std::size_t v = 0; v < vertex_count; ++v) graph.begin[v + 1] += graph.begin[v];
  graph.edges.resize(corners.size());
  std::vector<std::uint32_t> next(graph.begin.begin(), graph.begin.end() - 1);
  for (std::uint32_t f = 0; f + 1 < corner_begin.size(); ++f) {
    const std::uint32_t first = corner_begin[f], size = corner_begin[f + 1] - first;
    for (std::uint32_t k = 0; k < size; ++k) {
      graph.edges[next[corners[first + k]]++] = {corners[first + (k + 1 < size ? k + 1 : 0)], f, k};
    }
  }
  for (std::size_t v = 0; v < vertex_count; ++v) {
    std::sort(graph.edges.begin() + graph.begin[v], graph.edges.begin() + graph.begin[v + 1],
              [](const FacetGraph::Edge& e, const FacetGraph::Edge& f) { return e.to < f.to; });
  }
}

}  // namespace

std::optional<FacetGraph::Edge> FacetGraph::edge(std::uint32_t from, std::uint32_t to) const {
  const auto first = edges.begin() + begin[from], last = edges.begin() + begin[from + 1];
  const auto found = std::lower_bound(first, last, to, [](const Edge& e, std::uint32_t v) { return e.to < v; });
  if (found == last || found->to != to) return std::nullopt;
  return *found;
}

std::uint32_t FacetGraph::facet_of(std::uint32_t u, std::uint32_t v, std::uint32_t w) const {
  for (const auto& [from, to] : {std::array{u, v}, std::array{v, w}, std::array{w, u}}) {
    if (const auto found = edge(from, to)) return found->facet;
  }
  SUNDER_REQUIRE(false);
  return 0;
}

std::size_t FacetGraph::memory() const {
  return sizeof(*this) + facets.memory() + begin.capacity() * sizeof(begin[0]) + edges.capacity() * sizeof(edges[0]);
}

FacetGraph make_facet_graph(std::span<const Point3> vertices, std::span<const std::uint32_t> corner_begin,
                            std::span<const std::uint32_t> corners) {
  FacetGraph graph;
  add_edges(graph, vertices.size(), corner_begin, corners);
  if (corner_begin.size() <= 3) return graph;
  Polar polar = make_polar(vertices, corner_begin, corners);
  graph.center = polar.center;
  Point3 low = vertices[0], high = low;
  for (const Point3& p : vertices) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) graph.to_one[k] = near_one(low[k], high[k]);
  for (Point3& p : polar.vertices) {
    for (std::size_t k = 0; k < 3; ++k) p[k] /= graph.to_one[k];
  }
  graph.facets = make_search_graph(std::move(polar.vertices), std::move(polar.edge_begin), std::move(polar.neighbours));
  return graph;
}

}  // namespace sunder::solid
