#include <sunder/planar/region/kernel_json.h>
#include <sunder/planar/region/regions_json.h>
#include <sunder/planar/set/tables_json.h>

#include <array>

namespace sunder::planar {

std::string certificate_text(const PolygonSides& polygon, const Region& kernel) {
  std::string text = json_file_begin;
  text += " \"rings\": [\n  [";
  for (std::uint32_t k = 0; k < polygon.size(); ++k) {
    if (k > 0) text += k % 4 == 0 ? ",\n   " : ", ";
    append_doubles(text, std::array{polygon.vertices()[k].x, polygon.vertices()[k].y});
  }
  text += "]],\n \"statements\": [\n  {\"question\": \"kernel\", \"ring\": 0, ";
  append_region(text, kernel);
  return text + "}]}\n";
}

}  // namespace sunder::planar
