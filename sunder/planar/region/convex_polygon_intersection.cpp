#include <sunder/base/names.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/predicate/line/arrows.h>

namespace sunder::planar {

std::string_view name_of(PolygonsPartKind kind) {
  return name_in<PolygonsPartKind::plane>({"empty", "point", "segment", "polygon", "plane"}, kind);
}

LinePoint corner_point(std::span<const ConvexPolygon> polygons, const PolygonsCorner& corner) {
  const ConvexPolygon& p = polygons[corner.a.polygon];
  if (corner.is_vertex) return line_point(p[corner.a.number]);
  const ConvexPolygon& q = polygons[corner.b.polygon];
  const std::uint32_t e = corner.a.number, f = corner.b.number;
  return line_point(Crossing{p[e], p[p.next(e)], q[f], q[q.next(f)]});
}

bool is_contradiction(std::span<const ConvexPolygon> polygons, std::span<const PolygonSupport> supports) {
  std::vector<LeftOfMoved> half_planes;
  for (const PolygonSupport& s : supports) {
    if (s.vertex.polygon >= polygons.size() || s.from == s.to) return false;
    const ConvexPolygon& p = polygons[s.vertex.polygon];
    if (s.vertex.number >= p.size()) return false;
    const Point2& at = p[s.vertex.number];
    for (const Point2& v : p.vertices()) {
      if (cross_2d(s.from, s.to, at, v) == Sign::negative) return false;
    }
    half_planes.push_back({at, s.from, s.to});
  }
  return have_no_common_point(half_planes);
}

PolygonsPart convex_polygon_intersection(std::span<const ConvexPolygon> polygons) {
  return convex_polygon_intersection_by_batches(polygons);
}

}  // namespace sunder::planar
