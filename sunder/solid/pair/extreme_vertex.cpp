#include <sunder/solid/pair/extreme_vertex.h>

namespace sunder::solid {

std::uint32_t extreme_vertex_from(const Placed& body, Along& along, End end, std::uint32_t start, Cost& cost,
                                  StageTally& tally) {
  const SearchGraph& graph = body.graph;
  const Sign further = static_cast<Sign>(end);
  VertexBlock block = graph.block(graph.place[start]);
  while (true) {
    const std::uint32_t count = block.count();
    cost.probes += count;
    const double *x = block.x(), *y = block.y(), *z = block.z();
    const Point3 at = block.at();
    const double reach = graph.sizes.greatest;
    const std::uint32_t padded = block.padded();  // what is left over repeats a neighbour
    const bool sure = padded > 0 && (end == End::greatest ? along.surely_less_far(x, y, z, padded, at, reach)
                                                          : along.surely_further(x, y, z, padded, at, reach));
    if (sure) {
      tally.rounded += count;
      return block.vertex();
    }
    std::uint32_t j = 0;
    while (j < count && along.compare(at, {x[j], y[j], z[j]}, &tally) != further) ++j;
    if (j == count) return block.vertex();
    block = graph.block(block.place(j));
  }
}

}  // namespace sunder::solid
