#include <sunder/base/error.h>
#include <sunder/solid/object/search_graph.h>
#include <sunder/solid/object/search_graph_walk.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::solid {

namespace {

// The direction that unfolds to (u, v).
Point3 folded(double u, double v) {
  const double z = 1 - std::fabs(u) - std::fabs(v);
  if (z >= 0) return {u, v, z};
  return {std::copysign(1 - std::fabs(v), u), std::copysign(1 - std::fabs(u), v), z};
}

void fill_table(SearchGraph& graph) {
  const std::uint32_t side =
      static_cast<std::uint32_t>(std::ceil(std::sqrt(8.0 * static_cast<double>(graph.vertices.size()))));
  graph.side = side;
  graph.table.assign(std::size_t{side} * side, 0);
  std::uint32_t last = graph.place[0];
  std::uint64_t steps_left = 8 * graph.table.size();  // of all walks: some are long where one facet has many vertices
  std::size_t slow = 0;
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t step = 0; step < side; ++step) {                    // side^2 is about 8 n, and n < 2^28
      const std::uint32_t column = row % 2 == 0 ? step : side - 1 - step;  // to and fro: cells in turn are adjacent
      const Point3 direction = folded((2.0 * column + 1) / side - 1, (2.0 * row + 1) / side - 1);
      std::uint64_t probes = 0;
      const Walk end = walk(graph, direction, last, probes, most_steps + steps_left);
      steps_left -= std::min(steps_left, end.steps);
      slow += !end.has_ended || end.steps > most_steps;
      last = end.place;
      graph.table[row * side + column] = last;
    }
  }
  if (slow <= graph.table.size() / 4) return;
  graph.is_slow = true;
  graph.side = 0;
  graph.table = {};
}

// A word of two halves, as VertexBlock reads it.
double word(std::uint32_t low, std::uint32_t high) {
  return std::bit_cast<double>(std::uint64_t{low} | std::uint64_t{high} << 32);
}

void fill_blocks(SearchGraph& graph) {
  const std::size_t n = graph.vertices.size();
  std::size_t size = 0;
  for (std::size_t v = 0; v < n; ++v) {
    const std::uint32_t count = graph.begin[v + 1] - graph.begin[v];
    graph.place.push_back(static_cast<std::uint32_t>(size));
    size += 4 + std::size_t{VertexBlock::padded(count)} / 2 * 7;
    if (size > std::numeric_limits<std::uint32_t>::max()) {
      throw Error(ErrorCode::bad_shape, "a body this large has no place in memory; give it fewer vertices");
    }
  }
  graph.blocks.reserve(size + VertexBlock::words_ahead);
  for (std::size_t v = 0; v < n; ++v) {
    const std::span<const std::uint32_t> around(graph.neighbours.data() + graph.begin[v],
                                                graph.begin[v + 1] - graph.begin[v]);
    const std::uint32_t count = static_cast<std::uint32_t>(around.size());
    const Point3& p = graph.vertices[v];
    graph.blocks.insert(graph.blocks.end(), {p.x, p.y, p.z, word(static_cast<std::uint32_t>(v), count)});
    const std::uint32_t padded = VertexBlock::padded(count);
    const auto neighbour = [&](std::uint32_t j) { return around[j < count ? j : 0]; };
    for (std::uint32_t j = 0; j < padded; ++j) graph.blocks.push_back(graph.vertices[neighbour(j)].x);
    for (std::uint32_t j = 0; j < padded; ++j) graph.blocks.push_back(graph.vertices[neighbour(j)].y);
    for (std::uint32_t j = 0; j < padded; ++j) graph.blocks.push_back(graph.vertices[neighbour(j)].z);
    for (std::uint32_t j = 0; j < padded; j += 2) {
      graph.blocks.push_back(word(graph.place[neighbour(j)], graph.place[neighbour(j + 1)]));
    }
  }
  graph.blocks.resize(size + VertexBlock::words_ahead);
}

void fill_all(SearchGraph& graph) {
  const std::uint32_t n = static_cast<std::uint32_t>(graph.vertices.size());
  graph.padded = (n + 3) / 4 * 4;
  graph.all.resize(std::size_t{3} * graph.padded);
  for (std::uint32_t i = 0; i < graph.padded; ++i) {
    const Point3& p = graph.vertices[i < n ? i : 0];
    graph.all[i] = p.x;
    graph.all[graph.padded + i] = p.y;
    graph.all[2 * graph.padded + i] = p.z;
  }
}

}  // namespace

SearchGraph make_search_graph(std::vector<Point3> given, std::vector<std::uint32_t> neighbour_begin,
                              std::vector<std::uint32_t> neighbours) {
  SearchGraph graph;
  graph.vertices = std::move(given);
  graph.begin = std::move(neighbour_begin);
  graph.neighbours = std::move(neighbours);
  const std::span<const Point3> vertices = graph.vertices;
  fill_blocks(graph);
  graph.sizes = size_range(vertices);
  graph.low = graph.high = vertices[0];
  for (const Point3& p : vertices) {
    graph.low = {std::min(graph.low.x, p.x), std::min(graph.low.y, p.y), std::min(graph.low.z, p.z)};
    graph.high = {std::max(graph.high.x, p.x), std::max(graph.high.y, p.y), std::max(graph.high.z, p.z)};
  }
  graph.middle = {graph.low.x / 2 + graph.high.x / 2, graph.low.y / 2 + graph.high.y / 2,
                  graph.low.z / 2 + graph.high.z / 2};
  if (vertices.size() <= SearchGraph::few) {
    fill_all(graph);
  } else {
    fill_table(graph);
  }
  return graph;
}

}  // namespace sunder::solid
