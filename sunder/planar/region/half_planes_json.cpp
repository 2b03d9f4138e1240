#include <sunder/planar/region/half_planes_json.h>
#include <sunder/planar/region/regions_json.h>
#include <sunder/planar/set/tables_json.h>

namespace sunder::planar {

template <class Given>
std::string certificate_text(const Given& given, const Region& region) {
  std::string text = json_file_begin;
  append_half_planes(text, given);
  text += ",\n \"statements\": [\n  {\"question\": \"half_planes\", ";
  append_region(text, region);
  return text + "}]}\n";
}

template std::string certificate_text(const Constraints&, const Region&);
template std::string certificate_text(const HalfPlanes&, const Region&);

}  // namespace sunder::planar
