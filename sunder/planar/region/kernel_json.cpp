#include <sunder/planar/region/kernel_json.h>
#include <sunder/planar/region/regions_json.h>

#include <array>
#include <string_view>

namespace sunder::planar {

std::string certificate_text(const PolygonSides& polygon, const Region& kernel, const Origin& origin) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin(origin);
  file.begin_table("rings");
  file.begin_rows();
  for (const Point2& p : polygon.vertices()) file.add_row(std::array{p.x, p.y});
  file.end_rows();
  file.end_table();
  file.begin_statement("kernel");
  file.index("ring", 0);
  write_region(file, polygon, kernel);
  file.end();
  return text;
}

}  // namespace sunder::planar
