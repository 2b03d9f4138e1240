// What the methods for the common part of discs begin and end with.
#pragma once

#include <sunder/planar/region/arc_chain.h>
#include <sunder/planar/region/disc_intersection.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// The circles, or, where all stay exact, times one power of two, so that the greatest number is about one: for the
// first stages of predicates. The common part has the same arcs.
std::vector<Disc> of_moderate_size(std::span<const Disc> circles);

// A point inside of all of them, near the deepest one. Requires that this is inside.
Viewpoint inside_of_all(std::span<const Disc> circles, const DeepestPoint& deepest, Cost& cost);

// The discs of a chain that goes once round, as DiscIntersection has them.
std::vector<std::uint32_t> arcs_of(std::span<const ArcPiece> chain);

// Kind and deepest point; then, of a region, the arcs as `chain_of(circles, chains, cost)` finds them.
template <class ChainOf>
DiscIntersection circles_part(const Discs& circles, const ChainOf& chain_of) {
  DiscIntersection out;
  if (circles.size() == 0) return out;
  const std::vector<Disc> moderate = of_moderate_size(circles.all());
  const auto [deepest, cost] = discs_deepest(moderate);
  out.deepest = deepest;
  out.cost = cost;
  out.kind = deepest.power == Sign::positive ? DiscIntersectionKind::empty
             : deepest.power == Sign::zero   ? DiscIntersectionKind::point
                                             : DiscIntersectionKind::region;
  if (out.kind != DiscIntersectionKind::region) return out;
  ArcChains chains(moderate, inside_of_all(moderate, deepest, out.cost));
  out.arcs = arcs_of(chain_of(moderate, chains, out.cost));
  out.cost.probes += chains.cost().probes;
  out.cost.exact += chains.cost().exact;
  return out;
}

}  // namespace sunder::planar
