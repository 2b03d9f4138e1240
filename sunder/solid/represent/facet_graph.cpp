#include <sunder/base/contract.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/polar.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace sunder::solid {

namespace {

// Spreads the lowest ten bits of x to every third bit.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 times(const Point3& a, const Point3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
Point3 over(const Point3& a, const Point3& b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

// The facets as seen from a point that is `by` further: n.(y - by) = h - n.by.
std::vector<Point3> seen_from(std::span<const Point3> facets, const Point3& by) {
  std::vector<Point3> moved;
  moved.reserve(facets.size());
  for (const Point3& m : facets) {
    const double left = 1 - dot(m, by);
    moved.push_back({m.x / left, m.y / left, m.z / left});
  }
  return moved;
}

// The square of one over the distance of the nearest facet; infinite where the point is not inside.
double one_over_nearest(std::span<const Point3> facets, const Point3& by) {
  double greatest = 0;
  for (const Point3& m : facets) {
    const double left = 1 - dot(m, by);
    if (!(left > 0x1p-20)) return std::numeric_limits<double>::infinity();
    greatest = std::max(greatest, dot(m, m) / (left * left));
  }
  return greatest;
}

// Facets along a Morton curve on the sphere of their normals.
std::vector<std::uint32_t> order_along_curve(std::span<const Point3> facets) {
  std::vector<std::uint32_t> code, order(facets.size());
  code.reserve(facets.size());
  for (const Point3& m : facets) {
    const double length = std::sqrt(dot(m, m));
    const auto cell = [&](double x) {
      const double part = x / length * 0.5 + 0.5;
      return part >= 0 && part <= 1 ? static_cast<std::uint32_t>(part * 1023) : 0u;
    };
    code.push_back(spread(cell(m.x)) | spread(cell(m.y)) << 1 | spread(cell(m.z)) << 2);
  }
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return code[i] != code[j] ? code[i] < code[j] : i < j; });
  return order;
}

// The polar's vertices and edges in this order.
SearchGraph search_graph_of(const Polar& polar, std::span<const Point3> facets, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> rank(order.size()), begin{0}, neighbours;
  for (std::uint32_t k = 0; k < order.size(); ++k) rank[order[k]] = k;
  std::vector<Point3> vertices;
  vertices.reserve(order.size());
  neighbours.reserve(polar.neighbours.size());
  for (const std::uint32_t f : order) {
    vertices.push_back(facets[f]);
    for (std::uint32_t k = polar.edge_begin[f]; k < polar.edge_begin[f + 1]; ++k) {
      neighbours.push_back(rank[polar.neighbours[k]]);
    }
    begin.push_back(static_cast<std::uint32_t>(neighbours.size()));
  }
  return make_search_graph(std::move(vertices), std::move(begin), std::move(neighbours));
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
  return sizeof(*this) + facets.memory() + begin.capacity() * sizeof(begin[0]) + edges.capacity() * sizeof(edges[0]) +
         number.capacity() * sizeof(number[0]);
}

FacetGraph FacetGraph::make(const ConvexPolyhedron& body) {
  const std::span<const Point3> vertices = body.vertices();
  SUNDER_REQUIRE(vertices.size() >= 3);
  FacetGraph graph;
  add_edges(graph, vertices.size(), body.facet_begin(), body.facet_vertices());
  if (body.dimension() == 2) return graph;
  const Polar polar = Polar::make(body);
  const auto [low, high] = body.box();
  Point3 mean;
  for (const Point3& p : vertices) {
    for (std::size_t k = 0; k < 3; ++k) mean[k] += p[k] / static_cast<double>(vertices.size());
  }
  Point3 middle;
  for (std::size_t k = 0; k < 3; ++k) {
    const double half = high[k] / 2 - low[k] / 2;  // no overflow
    graph.to_one[k] = std::min(1 / half, std::numeric_limits<double>::max());
    middle[k] = low[k] + half;
  }
  std::vector<Point3> facets = polar.vertices;
  for (Point3& m : facets) m = over(m, graph.to_one);
  // The polar's own point is inside, and may be near a facet.
  graph.center = polar.center;
  double least = one_over_nearest(facets, {});
  Point3 best;
  for (const Point3& candidate : {middle, mean}) {
    const Point3 by = times(minus(candidate, polar.center), graph.to_one);
    const double of_candidate = one_over_nearest(facets, by);
    if (!(of_candidate < least)) continue;
    least = of_candidate;
    best = by;
    graph.center = candidate;
  }
  facets = seen_from(facets, best);
  graph.number = order_along_curve(facets);
  graph.facets = search_graph_of(polar, facets, graph.number);
  return graph;
}

}  // namespace sunder::solid
