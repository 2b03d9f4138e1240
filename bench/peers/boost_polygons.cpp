// Boost.Geometry, header only, in doubles.
#include <bench/peers/polygon_peer.h>

#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <type_traits>
#include <utility>
#include <vector>

namespace bench {
namespace {

namespace bg = boost::geometry;

using Point = bg::model::d2::point_xy<double>;
using Ring = bg::model::ring<Point, false, true>;  // counter-clockwise, its first vertex repeated
using Polygon = bg::model::polygon<Point, false, true>;

// Shape: Ring or Polygon.
template <class Shape>
Run by_intersects(const PolygonScenario& scenario) {
  std::vector<Shape> shapes;
  for (const sunder::planar::ConvexPolygon& given : scenario.polygons) {
    Ring ring;
    ring.reserve(given.size() + 1);
    for (const sunder::Point2& p : given.vertices()) ring.emplace_back(p.x, p.y);
    ring.emplace_back(given[0].x, given[0].y);
    if constexpr (std::is_same_v<Shape, Ring>) {
      shapes.push_back(std::move(ring));
    } else {
      shapes.emplace_back().outer() = std::move(ring);
    }
  }
  return run_over(scenario, [shapes = std::move(shapes)](const PolygonPair& pair) {
    return bg::intersects(shapes[pair.a], shapes[pair.b]);
  });
}

}  // namespace

std::vector<PolygonWay> boost_polygon_ways() {
  return {{"boost", "intersects of rings", by_intersects<Ring>},
          {"boost", "intersects of polygons", by_intersects<Polygon>}};
}

}  // namespace bench
