#include <sunder/planar/set/tables_json.h>

#include <array>

namespace sunder::planar {

void append_double(std::string& text, double x) { text += '"' + Dyadic(x).hexadecimal() + '"'; }

void append_indices(std::string& text, std::span<const std::uint32_t> indices) {
  text += '[';
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (k > 0) text += k % 32 == 0 ? ",\n     " : ",";
    text += indices[k] == 0xffffffffu ? "-1" : std::to_string(indices[k]);
  }
  text += ']';
}

void append_point(std::string& text, const ExactPoint2& p) {
  text += "[\"" + fraction_text(p.x, p.denominator) + "\", \"" + fraction_text(p.y, p.denominator) + "\"]";
}

void append_doubles(std::string& text, std::span<const double> numbers) {
  text += '[';
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (k > 0) text += ',';
    append_double(text, numbers[k]);
  }
  text += ']';
}

void append_convex_polygons(std::string& text, std::span<const ConvexPolygon> polygons) {
  text += " \"convex_polygons\": [";
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    text += i > 0 ? ",\n  [" : "\n  [";
    for (std::uint32_t v = 0; v < polygons[i].size(); ++v) {
      if (v > 0) text += ", ";
      append_doubles(text, std::array{polygons[i][v].x, polygons[i][v].y});
    }
    text += ']';
  }
  text += ']';
}

}  // namespace sunder::planar
