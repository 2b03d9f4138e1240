#include <sunder/base/contract.h>
#include <sunder/solid/hull/canonical_order.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace sunder::solid {

namespace {

// Appends a cycle of vertices under their new numbers, the lowest first.
void append_cycle(std::span<const std::uint32_t> cycle, std::span<const std::uint32_t> number,
                  std::vector<std::uint32_t>& begin, std::vector<std::uint32_t>& vertices) {
  const auto added = static_cast<std::ptrdiff_t>(vertices.size());
  for (const std::uint32_t v : cycle) vertices.push_back(number[v]);
  std::rotate(vertices.begin() + added, std::min_element(vertices.begin() + added, vertices.end()), vertices.end());
  begin.push_back(static_cast<std::uint32_t>(vertices.size()));
}

std::span<const std::uint32_t> part(const std::vector<std::uint32_t>& begin, const std::vector<std::uint32_t>& all,
                                    std::uint32_t i) {
  return std::span(all).subspan(begin[i], begin[i + 1] - begin[i]);
}

// The facets in order. They are given with the lowest vertex first. No two agree in the first two vertices, because
// only one facet is on the left of an edge; for a flat hull, because a polygon with three or more vertices and its
// reverse differ in the second.
std::vector<std::uint32_t> facet_order(const ConvexHull& hull) {
  const auto facet_count = static_cast<std::uint32_t>(hull.facet_begin.size() - 1);
  const auto vertex = [&](std::uint32_t f, std::uint32_t i) { return hull.facet_vertices[hull.facet_begin[f] + i]; };

  std::vector<std::uint32_t> begin(hull.vertices.size() + 1);  // of the facets with a certain first vertex
  for (std::uint32_t f = 0; f < facet_count; ++f) ++begin[vertex(f, 0) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());

  std::vector<std::uint32_t> order(facet_count);
  std::vector<std::uint32_t> end = begin;
  for (std::uint32_t f = 0; f < facet_count; ++f) order[end[vertex(f, 0)]++] = f;
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    std::sort(order.begin() + begin[v], order.begin() + end[v],
              [&](std::uint32_t f, std::uint32_t g) { return vertex(f, 1) < vertex(g, 1); });
  }
  return order;
}

}  // namespace

ConvexHull in_canonical_order(const ConvexHull& hull, std::size_t point_count) {
  SUNDER_REQUIRE(std::all_of(hull.vertices.begin(), hull.vertices.end(), [&](auto v) { return v < point_count; }));
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> vertex_at(point_count, none);
  for (std::uint32_t v = 0; v < hull.vertices.size(); ++v) vertex_at[hull.vertices[v]] = v;

  ConvexHull result;
  result.dimension = hull.dimension;
  result.side_tests = hull.side_tests;
  std::vector<std::uint32_t> number(hull.vertices.size());
  for (const std::uint32_t v : vertex_at) {
    if (v == none) continue;
    number[v] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(hull.vertices[v]);
  }

  for (const std::uint32_t v : vertex_at) {
    if (v == none) continue;
    append_cycle(part(hull.neighbour_begin, hull.neighbours, v), number, result.neighbour_begin, result.neighbours);
  }

  ConvexHull unordered;
  unordered.vertices = result.vertices;
  for (std::uint32_t f = 0; f + 1 < hull.facet_begin.size(); ++f) {
    append_cycle(part(hull.facet_begin, hull.facet_vertices, f), number, unordered.facet_begin,
                 unordered.facet_vertices);
  }
  for (const std::uint32_t f : facet_order(unordered)) {
    const auto cycle = part(unordered.facet_begin, unordered.facet_vertices, f);
    result.facet_vertices.insert(result.facet_vertices.end(), cycle.begin(), cycle.end());
    result.facet_begin.push_back(static_cast<std::uint32_t>(result.facet_vertices.size()));
  }
  return result;
}

}  // namespace sunder::solid
