#include <sunder/planar/region/regions_json.h>
#include <sunder/planar/set/tables_json.h>

#include <array>

namespace sunder::planar {

namespace {

std::array<double, 3> numbers_of(const Constraint& h) { return {h.a, h.b, h.c}; }

std::array<double, 4> numbers_of(const LeftOf& h) { return {h.from.x, h.from.y, h.to.x, h.to.y}; }

template <class Given>
void append_table(std::string& text, const Given& given) {
  text += " \"half_planes\": [";
  for (std::uint32_t k = 0; k < given.size(); ++k) {
    text += k > 0 ? ",\n  " : "\n  ";
    append_doubles(text, numbers_of(given[k]));
  }
  text += ']';
}

}  // namespace

void append_half_planes(std::string& text, const Constraints& given) { append_table(text, given); }

void append_half_planes(std::string& text, const HalfPlanes& given) { append_table(text, given); }

void append_region(std::string& text, const Region& region) {
  text += "\"verdict\": \"" + std::string(name_of(region.kind)) + "\",\n   \"sides\": ";
  append_indices(text, region.sides);
  if (region.empty()) return;
  text += ",\n   \"cones\": ";
  append_indices(text, region.cones);
}

}  // namespace sunder::planar
