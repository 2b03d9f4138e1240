// CGAL, header only: its Boolean operations on polygons, and its intersection of boxes.
#include <bench/peers/polygon_peer.h>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/box_intersection_d.h>

#include <utility>
#include <vector>

namespace bench {
namespace {

using Constructing = CGAL::Exact_predicates_exact_constructions_kernel;
using Deciding = CGAL::Exact_predicates_inexact_constructions_kernel;

Run by_do_intersect(const PolygonScenario& scenario) {
  std::vector<CGAL::Polygon_2<Constructing>> shapes;
  for (const sunder::planar::ConvexPolygon& given : scenario.polygons) {
    CGAL::Polygon_2<Constructing>& shape = shapes.emplace_back();
    for (const sunder::Point2& p : given.vertices()) shape.push_back({p.x, p.y});
  }
  return run_over(scenario, [shapes = std::move(shapes)](const PolygonPair& pair) {
    return CGAL::do_intersect(shapes[pair.a], shapes[pair.b]);
  });
}

struct Found {};  // thrown through the library, which cannot be stopped otherwise

Run by_boxes(const PolygonScenario& scenario) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::uint32_t>;
  struct Prepared {
    std::vector<Deciding::Point_2> points;
    std::vector<Deciding::Segment_2> edges;
    std::vector<Box> boxes;
  };
  std::vector<Prepared> shapes;
  for (const sunder::planar::ConvexPolygon& given : scenario.polygons) {
    Prepared& shape = shapes.emplace_back();
    for (const sunder::Point2& p : given.vertices()) shape.points.emplace_back(p.x, p.y);
    for (std::uint32_t i = 0; i < given.size(); ++i) {
      shape.edges.emplace_back(shape.points[i], shape.points[i + 1 == given.size() ? 0 : i + 1]);
      shape.boxes.emplace_back(shape.edges.back().bbox(), i);
    }
  }
  const auto holds = [](const Prepared& shape, const Deciding::Point_2& p) {
    return CGAL::bounded_side_2(shape.points.begin(), shape.points.end(), p, Deciding()) != CGAL::ON_UNBOUNDED_SIDE;
  };
  return run_over(scenario, [shapes = std::move(shapes), holds](const PolygonPair& pair) mutable {
    Prepared &a = shapes[pair.a], &b = shapes[pair.b];
    try {
      CGAL::box_intersection_d(a.boxes.begin(), a.boxes.end(), b.boxes.begin(), b.boxes.end(),
                               [&](const Box& of_a, const Box& of_b) {
                                 if (CGAL::do_intersect(a.edges[of_a.info()], b.edges[of_b.info()])) throw Found();
                               });
    } catch (const Found&) {
      return true;
    }
    return holds(a, b.points.front()) || holds(b, a.points.front());
  });
}

}  // namespace

std::vector<PolygonWay> cgal_polygon_ways() {
  return {{"cgal", "do_intersect", by_do_intersect}, {"cgal", "boxes of edges", by_boxes}};
}

}  // namespace bench
