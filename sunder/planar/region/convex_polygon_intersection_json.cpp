#include <sunder/planar/region/convex_polygon_intersection_json.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/regions_json.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace sunder::planar {

namespace {

HalfPlane x_at_most(double x) { return HalfPlane::left_of({x, 0}, {x, 1}); }
HalfPlane x_at_least(double x) { return HalfPlane::left_of({x, 1}, {x, 0}); }
HalfPlane y_at_most(double y) { return HalfPlane::left_of({1, y}, {0, y}); }
HalfPlane y_at_least(double y) { return HalfPlane::left_of({0, y}, {1, y}); }

}  // namespace

std::vector<HalfPlane> sides_of(std::span<const ConvexPolygon> polygons) {
  std::vector<HalfPlane> sides;
  for (const ConvexPolygon& polygon : polygons) {
    const std::uint32_t n = polygon.size();
    const Point2 &p = polygon[0], &q = polygon[n - 1];
    if (n == 1) {
      sides.insert(sides.end(), {x_at_most(p.x), y_at_most(p.y), x_at_least(p.x), y_at_least(p.y)});
      continue;
    }
    for (std::uint32_t k = 0; k < n; ++k) {
      sides.push_back(HalfPlane::left_of(polygon[k], polygon[k + 1 == n ? 0 : k + 1]));
    }
    if (n > 2) continue;
    if (p.x != q.x) {
      sides.insert(sides.end(), {x_at_most(std::max(p.x, q.x)), x_at_least(std::min(p.x, q.x))});
    } else {
      sides.insert(sides.end(), {y_at_most(std::max(p.y, q.y)), y_at_least(std::min(p.y, q.y))});
    }
  }
  return sides;
}

std::string certificate_text(std::span<const ConvexPolygon> polygons, const Origin& origin) {
  const std::vector<HalfPlane> half = sides_of(polygons);
  const HalfPlanes sides(half);  // keeps a reference
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin(origin);
  file.begin_table("convex_polygons");
  for (const ConvexPolygon& polygon : polygons) {
    file.begin_rows();
    for (std::uint32_t k = 0; k < polygon.size(); ++k) file.add_row(std::array{polygon[k].x, polygon[k].y});
    file.end_rows();
  }
  file.end_table();
  file.begin_statement("convex_polygons_common_part");
  write_region(file, sides, half_plane_intersection(sides, {.evidence = true}));
  file.end();
  return text;
}

}  // namespace sunder::planar
