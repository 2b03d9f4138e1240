#include <sunder/base/contract.h>
#include <sunder/base/json.h>
#include <sunder/base/names.h>
#include <sunder/certificate/claims.h>
#include <sunder/certificate/said.h>

namespace sunder {

namespace {

std::string json_text(std::string_view text) { return json_string(cut_text(std::string(text))); }

// "key": value, behind others.
std::string member(std::string_view key, std::string_view value) {
  std::string text = ", \"";
  return text.append(key).append("\": ").append(value);
}

template <class Values, class Words>
std::string list_of(const Values& values, const Words& words_of) {
  std::string text = "[";
  for (const auto& value : values) text.append(text.size() > 1 ? ", " : "").append(words_of(value));
  return text.append("]");
}

std::string object(std::string_view kind, std::string_view members) {
  std::string text = "{\"is\": \"";
  return text.append(kind).append("\"").append(members).append("}");
}

std::string row_of(const std::string& text, const std::string& number) {
  std::string row = "[";
  return row.append(json_text(text)).append(", ").append(number).append("]");
}

std::string index_or_null(const std::optional<std::size_t>& index) { return index ? std::to_string(*index) : "null"; }

}  // namespace

Said Said::all(Source what, std::size_t input, std::string_view part, const std::vector<std::string>& without) {
  return Said(object(name_in<Source::shape>({"vertices", "triangles", "points", "half_spaces", "lines", "centre_lines",
                                             "polygons", "circles", "boxes", "half_planes", "shape"},
                                            what),
                     member("input", std::to_string(input)) + member("part", part.empty() ? "null" : json_text(part)) +
                         member("without", list_of(without, json_text))));
}

Said Said::given(std::string_view text) { return Said(object("given", member("text", json_text(text)))); }

Said Said::step(std::string_view kind, const std::string& members) const {
  SUNDER_REQUIRE(!empty());
  return Said(object(kind, members + member("of", json_)));
}

Said Said::hull() const { return step("hull", ""); }
Said Said::scaled(std::span<const double> by) const { return step("scaled", member("by", list_of(by, json_double))); }
Said Said::unit(std::string_view name) const { return step("unit", member("unit", json_text(name))); }
Said Said::projected(const std::array<double, 9>& origin_u_v) const {
  return step("projected", member("frame", list_of(origin_u_v, json_double)));
}
Said Said::dropped(std::string_view axis) const { return step("dropped", member("axis", json_text(axis))); }
Said Said::with_radius() const { return step("radius", ""); }
Said Said::mended(const std::vector<std::string>& changes) const {
  return step("mended", member("changes", list_of(changes, json_text)));
}
Said Said::in_system(std::string_view system) const { return step("system", member("system", json_text(system))); }

SaidNote SaidNote::joint_values(const std::vector<std::pair<std::string, double>>& values,
                                std::optional<std::size_t> row, std::optional<std::size_t> input) {
  SUNDER_REQUIRE(!values.empty());
  const auto of_joint = [](const auto& value) { return row_of(value.first, json_double(value.second)); };
  return SaidNote(object("joint_values", member("values", list_of(values, of_joint)) +
                                             member("row", index_or_null(row)) + member("from", index_or_null(input))));
}

SaidNote SaidNote::allowed(const std::vector<std::pair<std::string, std::uint64_t>>& reasons) {
  SUNDER_REQUIRE(!reasons.empty());
  const auto of_reason = [](const auto& reason) { return row_of(reason.first, std::to_string(reason.second)); };
  return SaidNote(object("allowed", member("pairs", list_of(reasons, of_reason))));
}

}  // namespace sunder
