// The vertex of a placed convex polyhedron that is furthest along a direction, exactly.
// Also called: support point, support mapping; hill climbing.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/search/placed.h>

#include <cstdint>

namespace sunder::solid {

// Which end of a direction.
enum class End : std::int8_t { least = -1, greatest = 1 };

// Walks from `start` over the vertex graph, by exact comparisons, until no neighbour is further: for a convex body that
// vertex is extreme. Where that takes more than most_steps, or a vertex has more than most_around neighbours
// (solid/object/search_graph_walk.h), goes down the hierarchy, by exact signs too. Of vertices that tie it is
// `start`, where that is one of them: then this is the relative check of a certificate, in floating point but for
// near-ties. `along` must be the direction seen from this body's frame. Requires start < number of vertices.
// Cost: O(log n) probes on every body: the degrees of the vertices on the way, then what the hierarchy asks about.
std::uint32_t extreme_vertex_from(const Placed& body, Along& along, End end, std::uint32_t start, Cost& cost,
                                  StageTally& tally);

// The same of the first `ranks` vertices of the hierarchy (represent/hierarchy.h), which are a level of it, or between
// two. Requires three vertices or more.
std::uint32_t extreme_vertex_of_ranks(const Placed& body, Along& along, End end, std::uint32_t ranks, Cost& cost,
                                      StageTally& tally);

// The same down the bounded hierarchy (represent/bounded_hierarchy.h) from its top, by that alone: no sectors, and no
// vertex that is near. Of the polyhedron; or where `ranks` is the end of a level, of that level, and if that is a cut
// point, the vertex from which it was cut. Requires three vertices or more. Cost: at most 7.5 log2 n probes for 8
// vertices and more (the constant tested).
std::uint32_t extreme_vertex_by_bounded(const Placed& body, Along& along, End end, Cost& cost, StageTally& tally,
                                        std::uint32_t ranks = 0xffffffff);

}  // namespace sunder::solid
