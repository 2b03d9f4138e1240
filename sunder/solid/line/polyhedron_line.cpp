#include <sunder/solid/line/line_search.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_answer.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>

namespace sunder::solid {

namespace {

PolyhedronCut cut_by_facets(const ConvexPolyhedron& body, const Pose& pose, const Point3& a, const Point3& b,
                            OwnEnds ends) {
  return cut_by(body, pose, a, b, ends, [](const Placed& placed, const Line& line, const auto& holds, Cost& cost) {
    return propose_by_facets(placed, line, holds, cost);
  });
}

}  // namespace

PolyhedronCut polyhedron_line(const ConvexPolyhedron& body, const Pose& pose, const Line& line) {
  return cut_by_facets(body, pose, line.a, line.b, {});
}

PolyhedronCut polyhedron_ray(const ConvexPolyhedron& body, const Pose& pose, const Ray& ray) {
  return cut_by_facets(body, pose, ray.a, ray.b, {.a = true, .b = false});
}

PolyhedronCut polyhedron_segment(const ConvexPolyhedron& body, const Pose& pose, const Segment& segment) {
  return cut_by_facets(body, pose, segment.a, segment.b, {.a = true, .b = true});
}

}  // namespace sunder::solid
