// What the methods for the common part of convex polygons begin and end with.
#pragma once

#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/edge_chain.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// The abscissas that all polygons reach over, and the lowest of the polygons that begin at the first, and end at the
// last.
struct CommonAbscissas {
  Abscissas between;
  std::uint32_t begins = 0, ends = 0;
};
CommonAbscissas common_abscissas(std::span<const ConvexPolygon> polygons);

// The common part of polygons whose upper and lower boundaries have these chains. The lower one is turned back.
// Requires low < high.
PolygonsPart closed_part(std::span<const ConvexPolygon> polygons, const CommonAbscissas& common,
                         std::span<const EdgePiece> upper, std::span<const EdgePiece> lower, StageTally& tally);

// The common part where the abscissas do not let it have an inside: low >= high. Cost: linear.
PolygonsPart thin_part(std::span<const ConvexPolygon> polygons, const CommonAbscissas& common);

// Turns a lower boundary over, either way.
void turn_over(std::span<EdgePiece> chain);

// The common part, where chain_of(boundary) gives the chain of all polygons, of lower ones turned over, and `chains`
// counts what they cost.
template <class ChainOf>
PolygonsPart part_of_chains(std::span<const ConvexPolygon> polygons, const CommonAbscissas& common, EdgeChains& chains,
                            const ChainOf& chain_of) {
  const std::vector<EdgePiece> upper = chain_of(Boundary::upper);
  std::vector<EdgePiece> lower = chain_of(Boundary::lower);
  turn_over(lower);
  PolygonsPart out = closed_part(polygons, common, upper, lower, chains.tally());
  out.cost.probes += chains.cost().probes;
  out.cost.exact = chains.cost().exact;
  return out;
}

}  // namespace sunder::planar
