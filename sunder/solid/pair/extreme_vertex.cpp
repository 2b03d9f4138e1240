#include <sunder/solid/pair/extreme_vertex.h>

namespace sunder::solid {

std::uint32_t extreme_vertex_from(const Placed& body, Along& along, End end, std::uint32_t start, StageTally& tally) {
  const SearchGraph& graph = body.graph;
  const Sign further = static_cast<Sign>(end);
  std::uint32_t at = start;
  while (true) {
    const std::uint32_t first = graph.begin[at];
    const std::uint32_t count = graph.begin[at + 1] - first;
    const double* x = graph.coordinates.data() + 3 * std::size_t{first};
    const bool sure = end == End::greatest
                          ? along.surely_less_far(x, x + count, x + 2 * count, count, graph.vertices[at], graph.sizes.greatest)
                          : along.surely_further(x, x + count, x + 2 * count, count, graph.vertices[at], graph.sizes.greatest);
    if (sure) {
      tally.rounded += count;
      return at;
    }
    std::uint32_t j = 0;
    while (j < count && along.compare(graph.vertices[at], {x[j], x[count + j], x[2 * count + j]}, &tally) != further) ++j;
    if (j == count) return at;
    at = graph.neighbours[first + j];
  }
}

}  // namespace sunder::solid
