#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/half_edges.h>

#include <numeric>

namespace sunder::solid {

namespace {

// Numbers in groups: group v is items[begin[v] .. begin[v + 1]).
struct Groups {
  std::vector<std::uint32_t> begin, items;
};

// For each vertex the half-edges with that end there, in the order in which for_each gives them.
template <class ForEach>
Groups grouped(std::uint32_t vertex_count, std::span<const std::uint32_t> end, const ForEach& for_each) {
  Groups groups{std::vector<std::uint32_t>(vertex_count + 1, 0), std::vector<std::uint32_t>(end.size())};
  for (const std::uint32_t v : end) ++groups.begin[v + 1];
  std::partial_sum(groups.begin.begin(), groups.begin.end(), groups.begin.begin());
  std::vector<std::uint32_t> next(groups.begin.begin(), groups.begin.end() - 1);
  for_each([&](std::uint32_t e) { groups.items[next[end[e]]++] = e; });
  return groups;
}

}  // namespace

HalfEdges HalfEdges::make(const ConvexPolyhedron& body) {
  const std::span<const std::uint32_t> facet_begin = body.facet_begin(), facet_vertices = body.facet_vertices();
  const std::uint32_t vertex_count = static_cast<std::uint32_t>(body.vertices().size());
  SUNDER_REQUIRE(vertex_count >= 3);
  const std::uint32_t count = static_cast<std::uint32_t>(facet_vertices.size());
  HalfEdges made;
  made.facet_begin = facet_begin;
  made.origin = facet_vertices;
  made.facet.resize(count);
  std::vector<std::uint32_t> tip(count);
  for (std::uint32_t f = 0; f + 1 < facet_begin.size(); ++f) {
    for (std::uint32_t e = facet_begin[f]; e < facet_begin[f + 1]; ++e) {
      made.facet[e] = f;
      tip[e] = facet_vertices[e + 1 < facet_begin[f + 1] ? e + 1 : facet_begin[f]];
    }
  }
  // Those into a vertex by where they start, then those out of it by where they end: the twins stand in one order.
  const auto in_turn = [&](const std::vector<std::uint32_t>& order) {
    return [&order](const auto& take) {
      for (const std::uint32_t e : order) take(e);
    };
  };
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0u);
  const Groups from = grouped(vertex_count, facet_vertices, in_turn(all));
  const Groups into = grouped(vertex_count, tip, in_turn(from.items));
  const Groups out = grouped(vertex_count, facet_vertices, in_turn(into.items));
  made.twin.resize(count);
  for (std::uint32_t k = 0; k < count; ++k) made.twin[into.items[k]] = out.items[k];

  made.begin = from.begin;
  made.out.resize(count);
  made.around.resize(count);
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    if (made.degree(v) == 0) continue;
    std::uint32_t e = from.items[made.begin[v]];
    for (std::uint32_t k = 0; k < made.degree(v); ++k) {
      made.out[made.begin[v] + k] = e;
      made.around[e] = k;
      const std::uint32_t f = made.facet[e], before = e == facet_begin[f] ? facet_begin[f + 1] - 1 : e - 1;
      e = made.twin[before];
    }
  }
  return made;
}

}  // namespace sunder::solid
