#include <sunder/base/error.h>
#include <sunder/planar/set/polygons_any_json.h>
#include <sunder/planar/set/polygons_common_point.h>
#include <sunder/planar/set/tables_json.h>

#include <algorithm>
#include <array>

namespace sunder::planar {

namespace {

void append_ring(std::string& text, std::span<const Point2> ring) {
  const bool is_point = std::all_of(ring.begin(), ring.end(), [&](const Point2& p) { return p == ring.front(); });
  if (is_point) throw Error(ErrorCode::bad_shape, "a ring is one point; leave it out");
  text += '[';
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (k > 0) text += ", ";
    append_doubles(text, std::array{ring[k].x, ring[k].y});
  }
  text += ']';
}

void append_polygons(std::string& text, std::span<const Polygon> polygons) {
  text += " \"polygons\": [";
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const Polygon& polygon = polygons[i];
    const std::span<const Point2> vertices(polygon.vertices());
    text += i > 0 ? ",\n  [" : "\n  [";
    for (std::uint32_t r = 0; r < polygon.ring_count(); ++r) {
      if (r > 0) text += ",\n   ";
      append_ring(text, vertices.subspan(polygon.ring_begin(r), polygon.ring_begin(r + 1) - polygon.ring_begin(r)));
    }
    text += ']';
  }
  text += ']';
}

}  // namespace

std::string certificate_text(std::span<const Polygon> polygons, Allowed allowed, const PolygonsAnswer& answer,
                             Groups groups) {
  std::string text = json_file_begin;
  append_polygons(text, polygons);
  text += ",\n \"statements\": [\n  {\"question\": \"polygons_any\", \"allowed\": \"" + std::string(name_of(allowed)) +
          "\", \"verdict\": \"" + (answer.meet() ? "some" : "none") + "\",\n   ";
  if (answer.meet()) {
    const std::uint32_t i = answer.found.i, j = answer.found.j;
    text += "\"i\": " + std::to_string(i) + ", \"j\": " + std::to_string(j) + ", \"point\": ";
    append_point(text, common_point(polygons[i], polygons[j], answer.found));
    if (!groups.empty()) {
      text += ",\n   \"groups\": ";
      append_indices(text, groups);
    }
  } else {
    text += "\"events\": ";
    append_indices(text, answer.transcript.events);
    text += ",\n   \"below\": ";
    append_indices(text, answer.transcript.below);
  }
  return text + "}]}\n";
}

}  // namespace sunder::planar
