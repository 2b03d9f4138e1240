// The vertex of a placed convex polyhedron that is furthest along a direction, exactly.
// Also called: support point, support mapping; hill climbing.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/predicate/along.h>
#include <sunder/solid/pair/placed.h>

#include <cstdint>

namespace sunder::solid {

// Which end of a direction.
enum class End : std::int8_t { least = -1, greatest = 1 };

// Walks from `start` over the vertex graph, by exact comparisons, until no neighbour is further: for a convex body that
// vertex is extreme. `along` must be the direction seen from this body's frame. Where `start` is extreme already this
// is the relative check of a certificate, in floating point but for near-ties.
// Cost: the degrees of the vertices on the way, as probes.
std::uint32_t extreme_vertex_from(const Placed& body, Along& along, End end, std::uint32_t start, Cost& cost,
                                  StageTally& tally);

}  // namespace sunder::solid
