#include <sunder/planar/region/regions_json.h>

#include <array>
#include <string>

namespace sunder::planar {

namespace {

std::array<double, 3> numbers_of(const Constraint& h) { return {h.a, h.b, h.c}; }

std::array<double, 4> numbers_of(const LeftOf& h) { return {h.from.x, h.from.y, h.to.x, h.to.y}; }

template <class Given>
void write_table(ClaimsWriter& file, const Given& given) {
  file.begin_table("half_planes");
  for (std::uint32_t k = 0; k < given.size(); ++k) file.add_row(numbers_of(given[k]));
  file.end_table();
}

template <class Given>
void write_contradiction(ClaimsWriter& file, const Given& given, const Region& region) {
  const std::vector<Dyadic> weights = multipliers(given, region);
  file.begin_claims();
  file.begin_claim("contradict");
  file.begin_list("weights");
  for (std::size_t k = 0; k < weights.size(); ++k) file.add_weight(region.sides[k], weights[k]);
  file.end_list();
}

}  // namespace

void write_half_planes(ClaimsWriter& file, const Constraints& given) { write_table(file, given); }

void write_half_planes(ClaimsWriter& file, const HalfPlanes& given) { write_table(file, given); }

template <class Given>
void write_region(ClaimsWriter& file, const Given& given, const Region& region) {
  file.text("verdict", std::string(name_of(region.kind)));
  if (region.empty()) {
    write_contradiction(file, given, region);
  } else {
    file.indices("sides", region.sides);
    file.begin_claims();
    file.begin_claim("cones");
    file.indices("cones", region.cones);
  }
  file.end_claim();
  file.end_statement();
}

template void write_region(ClaimsWriter&, const Constraints&, const Region&);
template void write_region(ClaimsWriter&, const HalfPlanes&, const Region&);
template void write_region(ClaimsWriter&, const PolygonSides&, const Region&);

}  // namespace sunder::planar
