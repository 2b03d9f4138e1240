#include <sunder/certificate/direction.h>
#include <sunder/planar/set/convex_polygons_any_json.h>
#include <sunder/planar/set/tables_json.h>
#include <sunder/predicate/common_point.h>

#include <array>
#include <vector>

namespace sunder::planar {

namespace {

const Affine3 in_place;

std::vector<Point3> in_space(const ConvexPolygon& polygon) {
  std::vector<Point3> vertices;
  vertices.reserve(polygon.size());
  for (const Point2& p : polygon.vertices()) vertices.push_back({p.x, p.y, 0});
  return vertices;
}

// Of two that became neighbours: what parts them.
std::string direction_text(std::span<const ConvexPolygon> polygons, const NeighboursEvidence& neighbours) {
  const std::vector<Point3> below = in_space(polygons[neighbours.below]), above = in_space(polygons[neighbours.above]);
  const Vector3<Dyadic> d =
      world_direction(neighbours.evidence.direction, {below, in_place, false}, {above, in_place, false}).exact();
  return "[\"" + d.x.hexadecimal() + "\", \"" + d.y.hexadecimal() + "\"]";
}

void append_meeting(std::string& text, const ConvexPolygon& a, const ConvexPolygon& b, const PairCertificate& c) {
  const std::vector<Point3> in_a = in_space(a), in_b = in_space(b);
  std::array<Posed, 5> points{};
  const std::size_t size = std::size_t{c.count_a} + c.count_b;
  for (std::size_t k = 0; k < size; ++k) {
    points[k] = {k < c.count_a ? in_a[c.vertices[k]] : in_b[c.vertices[k]], &in_place, false};
  }
  const std::span<const Posed> all(points.data(), size);
  const CommonPointWeights w = common_point_weights(all.first(c.count_a), all.subspan(c.count_a));
  const auto append_weights = [&](const char* key, std::size_t first, std::size_t count) {
    text += ",\n   \"" + std::string(key) + "\": [";
    for (std::size_t k = first; k < first + count; ++k) {
      if (k > first) text += ", ";
      text += '[' + std::to_string(c.vertices[k]) + ", \"" + fraction_text(w.numerators[k], w.denominator) + "\"]";
    }
    text += ']';
  };
  text += "\"point\": ";
  append_point(text, {w.point[0], w.point[1], w.denominator});
  append_weights("weights_i", 0, c.count_a);
  append_weights("weights_j", c.count_a, c.count_b);
}

}  // namespace

std::string certificate_text(std::span<const ConvexPolygon> polygons, Allowed allowed,
                             const ConvexPolygonsAnswer& answer, Groups groups) {
  std::string text = json_file_begin;
  append_convex_polygons(text, polygons);
  text += ",\n \"statements\": [\n  {\"question\": \"convex_polygons_any\", \"allowed\": \"" +
          std::string(name_of(allowed)) + "\", \"verdict\": \"" + (answer.meet() ? "some" : "none") + "\",\n   ";
  if (answer.meet()) {
    text += "\"i\": " + std::to_string(answer.i) + ", \"j\": " + std::to_string(answer.j) + ", \"contact\": \"" +
            std::string(name_of(answer.contact)) + "\", ";
    append_meeting(text, polygons[answer.i], polygons[answer.j], answer.evidence);
    if (!groups.empty()) {
      text += ",\n   \"groups\": ";
      append_indices(text, groups);
    }
  } else {
    text += "\"events\": ";
    append_indices(text, answer.transcript.events);
    text += ",\n   \"below\": ";
    append_indices(text, answer.transcript.below);
    text += ",\n   \"directions\": [";
    for (std::size_t k = 0; k < answer.transcript.neighbours.size(); ++k) {
      text += k > 0 ? ",\n    " : "\n    ";
      text += direction_text(polygons, answer.transcript.neighbours[k]);
    }
    text += ']';
  }
  return text + "}]}\n";
}

}  // namespace sunder::planar
