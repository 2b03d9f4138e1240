// GEOS, through its C interface.
#include <bench/peers/geos_context.h>
#include <bench/peers/polygon_peer.h>

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bench {
namespace {

std::vector<Geometry> geometries(const PolygonScenario& scenario) {
  std::vector<Geometry> made;
  for (const sunder::planar::ConvexPolygon& given : scenario.polygons) {
    const std::uint32_t n = given.size();
    GEOSCoordSequence* ring = GEOSCoordSeq_create_r(context(), n + 1, 2);
    for (std::uint32_t i = 0; i <= n; ++i) {
      const sunder::Point2& p = given[i == n ? 0 : i];
      GEOSCoordSeq_setXY_r(context(), ring, i, p.x, p.y);
    }
    made.emplace_back(GEOSGeom_createPolygon_r(context(), GEOSGeom_createLinearRing_r(context(), ring), nullptr, 0));
    if (made.back() == nullptr) throw std::runtime_error("GEOS made no geometry");
  }
  return made;
}

bool yes(char answer) {  // 0: no, 1: yes, 2: an exception
  if (answer != 0 && answer != 1) throw std::runtime_error("GEOS gave no answer");
  return answer == 1;
}

Run by_intersects(const PolygonScenario& scenario) {
  return run_over(scenario, [shapes = geometries(scenario)](const PolygonPair& pair) {
    return yes(GEOSIntersects_r(context(), shapes[pair.a].get(), shapes[pair.b].get()));
  });
}

Run by_prepared(const PolygonScenario& scenario) {
  std::vector<Geometry> shapes = geometries(scenario);
  std::vector<Prepared> prepared(shapes.size());
  for (const PolygonPair& pair : scenario.pairs) {
    if (prepared[pair.a] == nullptr) prepared[pair.a].reset(GEOSPrepare_r(context(), shapes[pair.a].get()));
    // The index comes with the first question.
    static_cast<void>(GEOSPreparedIntersects_r(context(), prepared[pair.a].get(), shapes[pair.b].get()));
  }
  return run_over(scenario, [shapes = std::move(shapes), prepared = std::move(prepared)](const PolygonPair& pair) {
    return yes(GEOSPreparedIntersects_r(context(), prepared[pair.a].get(), shapes[pair.b].get()));
  });
}

}  // namespace

std::vector<PolygonWay> geos_polygon_ways() {
  return {{"geos", "intersects", by_intersects}, {"geos", "prepared intersects", by_prepared}};
}

}  // namespace bench
