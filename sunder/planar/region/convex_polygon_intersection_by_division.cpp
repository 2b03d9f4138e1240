#include <sunder/planar/region/convex_polygon_intersection_closed.h>

#include <numeric>

namespace sunder::planar {

namespace {

template <class Divide>
PolygonsPart by(std::span<const ConvexPolygon> polygons, const Divide& divide) {
  if (polygons.empty()) return {};
  const CommonAbscissas common = common_abscissas(polygons);
  if (!(common.between.low < common.between.high)) return thin_part(polygons, common);
  std::vector<std::uint32_t> all(polygons.size());
  std::iota(all.begin(), all.end(), 0u);
  EdgeChains chains(polygons, common.between);
  return part_of_chains(polygons, common, chains, [&](Boundary boundary) { return divide(chains, all, boundary); });
}

}  // namespace

PolygonsPart convex_polygon_intersection_by_division(std::span<const ConvexPolygon> polygons) {
  return by(polygons, [](EdgeChains& chains, std::span<const std::uint32_t> all, Boundary boundary) {
    return chains.divide(all, boundary);
  });
}

PolygonsPart convex_polygon_intersection_by_edges(std::span<const ConvexPolygon> polygons) {
  return by(polygons, [](EdgeChains& chains, std::span<const std::uint32_t> all, Boundary boundary) {
    return chains.divide_edges(all, boundary);
  });
}

}  // namespace sunder::planar
