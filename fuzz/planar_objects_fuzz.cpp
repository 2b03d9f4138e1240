// Any bytes, read as planar objects of CSV, WKT and GeoJSON, then made convex polygons, lines, rays and half-planes, of
// which those that meet are asked for. Seeds: cases/planar-pair, cases/broken-planar.
#include <fuzz/require.h>

#include <sunder/base/error.h>
#include <sunder/io/plane/planar_objects.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/line.h>
#include <sunder/planar/pair/polygon_line.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

using sunder::fuzz::require;
namespace {

using sunder::io::PlanarObject;
using Kind = PlanarObject::Kind;

void check_line(const std::string& text) {
  require(!text.empty());
  for (const char c : text) require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
}

// The convex hull of the vertices exists; the vertices as they are, and mended, are a polygon or refused.
void check_bounded(const PlanarObject& object) {
  const std::size_t n = object.vertices.size();
  require(object.kind == Kind::point ? n == 1 : object.kind == Kind::segment ? n == 2 : n >= 3);
  const auto hull = sunder::planar::ConvexPolygon::hull_of(object.vertices);
  require(hull.size() >= 1 && hull.size() <= n);
  for (const auto mended : {false, true}) {
    try {
      const auto polygon = mended ? sunder::planar::ConvexPolygon::mended(object.vertices)
                                  : sunder::planar::ConvexPolygon::from_vertices(object.vertices);
      require(polygon.size() == hull.size());
    } catch (const sunder::Error& error) {
      check_line(error.what());
    }
  }
}

void check(std::string_view text, std::string_view place, bool drop_z) {
  sunder::io::PlanarFile file;
  try {
    file = sunder::io::parse_planar_objects(text, place, drop_z);
  } catch (const sunder::Error& error) {
    require(error.code() == sunder::ErrorCode::bad_file && std::string_view(error.what()).starts_with(place));
    check_line(error.what());
    return;
  }
  require(!file.objects.empty() && !file.format.empty());
  for (const std::string& remark : file.remarks) check_line(remark);
  std::uint32_t line = 0;
  const PlanarObject* first = nullptr;
  for (const PlanarObject& object : file.objects) {
    check_line(object.name);
    require(object.line >= line);
    line = object.line;
    check_line(object.problem.empty() ? "none" : object.problem);
    if (!object.problem.empty()) {
      require(object.vertices.empty());
      continue;
    }
    if (first == nullptr) first = &object;
    for (const sunder::Point2& p : object.vertices) require(std::isfinite(p.x) && std::isfinite(p.y));
    if (!object.unbounded()) {
      check_bounded(object);
      continue;
    }
    require(object.vertices.size() == 2);
    const auto through = sunder::planar::Line::through(object.vertices[0], object.vertices[1]);  // throws where equal
    if (first->unbounded() || first->vertices.size() > 100) continue;
    const auto hull = sunder::planar::ConvexPolygon::hull_of(first->vertices);
    const auto cut = sunder::planar::polygon_line(hull, through);
    require(cut.evidence == sunder::planar::polygon_line_by_scan(hull, {}, through).evidence);
  }
  require(first != nullptr);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const std::string_view place : {"a.csv", "a.wkt", "a.geojson", "a.json", "a"}) check(text, place, size % 2 == 0);
  return 0;
}
