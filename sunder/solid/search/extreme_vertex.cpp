#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/represent/bounded_hierarchy.h>
#include <sunder/solid/represent/bounded_walk.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/hierarchy_walk.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/extreme_vertex.h>

namespace sunder::solid {

std::uint32_t extreme_vertex_of_ranks(const Placed& body, Along& along, End end, std::uint32_t ranks, Cost& cost,
                                      StageTally& tally) {
  const Hierarchy& hierarchy = represent::of<Hierarchy>(body.body);
  const auto at = [&](std::uint32_t rank) -> const Point3& { return hierarchy.nodes[rank].at; };
  const bool turns_tame = body.turns_tame();
  const auto at_end = [end](Sign sign) { return end == End::greatest ? sign : -sign; };
  const auto compare = [&](std::uint32_t i, std::uint32_t j) { return at_end(along.compare(at(i), at(j), &tally)); };
  const auto turn = [&](std::uint32_t v, std::uint32_t i, std::uint32_t j) {
    const Hierarchy::Node& node = hierarchy.nodes[v];
    if (node.has_middle_in_doubles()) {
      return at_end(along.turn(node.middle, node.at, at(i), at(j), turns_tame, &tally));
    }
    const auto& [p, q] = node.middle_triangle;
    return at_end(along.turn_about_normal(at(p), at(q), node.at, at(i), at(j), &tally));
  };
  return hierarchy.nodes[HierarchyWalk(hierarchy, compare, turn, cost.probes).run(ranks)].vertex;
}

std::uint32_t extreme_vertex_from(const Placed& body, Along& along, End end, std::uint32_t start, Cost& cost,
                                  StageTally& tally) {
  const SearchGraph& graph = body.graph;
  const Sign further = static_cast<Sign>(end);
  VertexBlock block = graph.block(graph.place[start]);
  for (std::uint32_t step = 0; block.count() <= most_around && step <= most_steps; ++step) {
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
  const std::uint32_t found = body.by_bounded ? extreme_vertex_by_bounded(body, along, end, cost, tally)
                                              : extreme_vertex_of_ranks(body, along, end, Hierarchy::none, cost, tally);
  const Point3 &first = graph.vertices[start], &last = graph.vertices[found];
  return along.compare(first, last, &tally) == further ? found : start;
}

std::uint32_t extreme_vertex_by_bounded(const Placed& body, Along& along, End end, Cost& cost, StageTally& tally,
                                        std::uint32_t ranks) {
  const BoundedHierarchy& hierarchy = represent::of<BoundedHierarchy>(body.body);
  const auto compare_upwards = [&](std::uint32_t i, std::uint32_t j) {
    const BoundedHierarchy::Node &p = hierarchy.nodes[i], &q = hierarchy.nodes[j];
    if (p.copy == BoundedHierarchy::none && q.copy == BoundedHierarchy::none) return along.compare(p.at, q.at, &tally);
    const Guess guess = along.compare_within(p.at, q.at, hierarchy.error);
    if (is_sure(guess)) return counted(&StageTally::rounded, &tally, to_sign(guess));
    return along.compare(hierarchy.exact(i), hierarchy.exact(j), &tally);
  };
  const auto compare = [&](std::uint32_t i, std::uint32_t j) {
    const Sign sign = compare_upwards(i, j);
    return end == End::greatest ? sign : -sign;
  };
  return hierarchy.nodes[BoundedWalk(hierarchy, compare, cost.probes).run(ranks)].vertex;
}

}  // namespace sunder::solid
