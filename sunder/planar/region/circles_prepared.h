// What the methods for the common part of discs begin and end with.
#pragma once

#include <sunder/planar/region/arc_chain.h>
#include <sunder/planar/region/circles.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// The circles, or, where all stay exact, times one power of two, so that the greatest number is about one: for the
// first stages of predicates. The common part has the same arcs.
std::vector<Circle> of_moderate_size(std::span<const Circle> circles);

// A point inside of all of them, near the deepest one. Requires that this is inside.
Viewpoint inside_of_all(std::span<const Circle> circles, const CirclesDeepest& deepest, Cost& cost);

// The discs of a chain that goes once round, as CirclesPart has them.
std::vector<std::uint32_t> arcs_of(std::span<const ArcPiece> chain);

// Kind and deepest point; then, of a region, the arcs as `chain_of(circles, chains, cost)` finds them.
template <class ChainOf>
CirclesPart circles_part(const Circles& circles, const ChainOf& chain_of) {
  CirclesPart out;
  if (circles.size() == 0) return out;
  const std::vector<Circle> moderate = of_moderate_size(circles.all());
  out.deepest = circles_deepest(moderate);
  out.cost = out.deepest.cost;
  out.kind = out.deepest.power == Sign::positive ? CirclesPartKind::empty
             : out.deepest.power == Sign::zero   ? CirclesPartKind::point
                                                 : CirclesPartKind::region;
  if (out.kind != CirclesPartKind::region) return out;
  ArcChains chains(moderate, inside_of_all(moderate, out.deepest, out.cost));
  out.arcs = arcs_of(chain_of(moderate, chains, out.cost));
  out.cost.probes += chains.cost().probes;
  out.cost.exact += chains.cost().exact;
  return out;
}

}  // namespace sunder::planar
