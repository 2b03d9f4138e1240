#include <sunder/polytope/region/region_claims.h>

#include <variant>

namespace sunder::polytope {

namespace {

using Place = ExactPointN;

void begin(ClaimsWriter& file, const std::string& name, const Polytope& half_spaces, const char* question) {
  require_entries(half_spaces.size());
  file.begin_table("polytopes");
  file.begin_entry();
  file.text("name", name.empty() ? "unnamed" : cut_text(name));
  file.number("dimension", half_spaces.dimension());
  file.begin_list("half_spaces");
  for (std::uint32_t k = 0; k < half_spaces.size(); ++k) file.add_row(half_spaces.row(k));
  file.end_list();
  file.end_entry();
  file.end_table();
  file.begin_statement(question);
  file.index("half_spaces", 0);
}

void add_multipliers(ClaimsWriter& file, const char* claim, const Weights& multipliers) {
  file.begin_claim(claim);
  file.begin_list("multipliers");
  for (const auto& [row, numerator] : multipliers.parts) file.add_weight(row, numerator, multipliers.denominator);
  file.end_list();
  file.end_claim();
}

void add_keeps(ClaimsWriter& file, const Place& point) {
  file.begin_claim("keeps");
  file.begin_list("weights");
  file.end_list();
  file.fractions("at", point.numbers, point.denominator);
  file.end_claim();
}

void add_direction(ClaimsWriter& file, const char* claim, std::span<const Dyadic> direction) {
  file.begin_claim(claim);
  file.numbers("direction", direction);
  file.end_claim();
}

void add_evidence(ClaimsWriter& file, const OneOptimum& one) { add_multipliers(file, "tops_only", one.multipliers); }
void add_evidence(ClaimsWriter& file, const ManyOptima& many) {
  add_multipliers(file, "tops", many.multipliers);
  add_keeps(file, many.other);
  file.claim("another");
}
void add_evidence(ClaimsWriter& file, const AnyPoint&) { file.claim("no_objective"); }
void add_evidence(ClaimsWriter& file, const NoBound& far) { add_direction(file, "rises", far.direction); }
void add_evidence(ClaimsWriter& file, const NoPoint& none) { add_multipliers(file, "contradicted", none.multipliers); }

}  // namespace

void add_claims(ClaimsWriter& file, const std::string& name, const Polytope& half_spaces,
                const HalfSpaceRegion& region) {
  begin(file, name, half_spaces, "half_spaces");
  file.text("verdict", name_of(region.verdict()));
  const RegionExtent* const extent = extent_of(region);
  if (extent == nullptr) {
    file.begin_claims();
    add_multipliers(file, "contradicted", std::get<EmptyRegion>(region.evidence).contradiction);
    file.end_statement();
    return;
  }
  file.number("dimension", extent->dimension);
  file.begin_list("spanned_by");
  for (const Place& point : extent->points) {
    file.begin_entry();
    file.fractions("point", point.numbers, point.denominator);
    file.end_entry();
  }
  file.end_list();
  file.begin_claims();
  add_multipliers(file, "spans", extent->flat);
  if (const auto* bounded = std::get_if<BoundedRegion>(&region.evidence)) {
    add_multipliers(file, "enclosed", bounded->enclosing);
  } else {
    add_direction(file, "recedes", std::get<UnboundedRegion>(region.evidence).direction);
  }
  file.end_statement();
}

void add_claims(ClaimsWriter& file, const std::string& name, const Polytope& half_spaces,
                std::span<const double> objective, const LinearProgramAnswer& answer) {
  begin(file, name, half_spaces, "half_spaces_program");
  file.doubles("objective", objective);
  file.text("verdict", name_of(answer.verdict()));
  const ExactPointN* const point = named_point(answer.evidence);
  const ManyOptima* const many = std::get_if<ManyOptima>(&answer.evidence);
  if (point != nullptr) file.fractions("point", point->numbers, point->denominator);
  if (many != nullptr) file.fractions("as_good", many->other.numbers, many->other.denominator);
  file.begin_claims();
  if (point != nullptr) add_keeps(file, *point);
  std::visit([&](const auto& held) { add_evidence(file, held); }, answer.evidence);
  file.end_statement();
}

void add_claims(ClaimsWriter& file, const std::string& name, const Polytope& half_spaces,
                const RegionVertices& answer) {
  if (answer.region.verdict() != RegionKind::bounded) return add_claims(file, name, half_spaces, answer.region);
  const std::size_t d = half_spaces.dimension();
  begin(file, name, half_spaces, "half_spaces_vertices");
  file.text("verdict", "vertices");
  file.begin_list("vertices");
  for (const std::vector<Dyadic>& vertex : answer.found.vertices) {
    file.begin_entry();
    file.fractions("point", std::span(vertex).first(d), vertex[d]);
    file.end_entry();
  }
  file.end_list();
  file.begin_claims();
  file.begin_claim("normal_fan");
  file.begin_list("fans");
  for (const std::vector<std::uint32_t>& fan : answer.found.fans) {
    file.begin_list();
    for (std::size_t k = 0; k < fan.size(); k += d) file.add_list(std::span(fan).subspan(k, d));
    file.end_list();
  }
  file.end_list();
  file.end_claim();
  file.end_statement();
}

}  // namespace sunder::polytope
