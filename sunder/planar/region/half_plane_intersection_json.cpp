#include <sunder/planar/region/half_plane_intersection_json.h>
#include <sunder/planar/region/regions_json.h>

#include <string_view>

namespace sunder::planar {

template <class Given>
std::string certificate_text(const Given& given, const Region& region, const Origin& origin) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin(origin);
  write_half_planes(file, given);
  file.begin_statement("half_planes");
  write_region(file, given, region);
  file.end();
  return text;
}

template std::string certificate_text(const Constraints&, const Region&, const Origin&);
template std::string certificate_text(const HalfPlanes&, const Region&, const Origin&);

}  // namespace sunder::planar
