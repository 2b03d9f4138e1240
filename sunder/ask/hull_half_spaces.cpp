// sunder hull of half-spaces of two to six dimensions.
#include <sunder/ask/hull_polytope.h>
#include <sunder/ask/report.h>
#include <sunder/ask/said_of.h>

#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/polytope/region/region_claims.h>
#include <sunder/polytope/region/region_vertices.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace sunder::ask {

namespace {

using polytope::PolytopeVertices;
using polytope::RegionKind;
using polytope::RegionVertices;

constexpr std::size_t most_listed = 16;  // vertices, for people

std::vector<std::string> fractions_of(std::span<const Dyadic> vertex) {
  std::vector<std::string> result;
  for (const Dyadic& n : vertex.first(vertex.size() - 1)) result.push_back(fraction_text(n, vertex.back()));
  return result;
}

std::vector<double> about(std::span<const Dyadic> vertex) {
  constexpr double most = std::numeric_limits<double>::max();  // JSON has no infinity
  std::vector<double> result;
  for (const Dyadic& n : vertex.first(vertex.size() - 1)) {
    result.push_back(std::clamp(nearest_ratio(n, vertex.back()), -most, most));
  }
  return result;
}

// A line for each vertex: its fractions, and the half-spaces that end there.
std::string table_of(const PolytopeVertices& found, std::size_t d) {
  std::string text;
  for (std::size_t c = 1; c <= d; ++c) text += fmt::format("x{},", c);
  text += "half_spaces\n";
  for (std::size_t k = 0; k < found.vertices.size(); ++k) {
    text += fmt::format("{},{}\n", fmt::join(fractions_of(found.vertices[k]), ","), fmt::join(found.at[k], " "));
  }
  return text;
}

// About n / w; of numbers that no doubles are near, on which side of these they are.
std::string about_text(const Dyadic& n, const Dyadic& w) {
  const double x = nearest_ratio(n, w);
  if (std::isfinite(x)) return fmt::format("{:.10g}", x);
  return x > 0 ? "above 1.797693134e+308" : "below -1.797693134e+308";
}

// Fractions that are long are told about.
std::string place_of(std::span<const Dyadic> vertex) {
  const std::vector<std::string> fractions = fractions_of(vertex);
  const bool is_short = std::all_of(fractions.begin(), fractions.end(), [](const auto& x) { return x.size() <= 20; });
  if (is_short) return fmt::format("({})", fmt::join(fractions, ", "));
  std::vector<std::string> numbers;
  for (const Dyadic& n : vertex.first(vertex.size() - 1)) numbers.push_back(about_text(n, vertex.back()));
  return fmt::format("about ({})", fmt::join(numbers, ", "));
}

std::string text_of(const RegionVertices& answer) {
  const PolytopeVertices& found = answer.found;
  const std::size_t dimension = extent_of(answer.region)->dimension;
  std::string text = fmt::format("bounded, of dimension {}: a {}\n", dimension, name_of_hull(dimension));
  text += fmt::format("  vertices  {}\n", found.vertices.size());
  for (std::size_t k = 0; k < std::min(found.vertices.size(), most_listed); ++k) {
    text += fmt::format("    {}", place_of(found.vertices[k]));
    if (!found.at[k].empty()) {
      text += fmt::format(", of half-space{} {}", found.at[k].size() == 1 ? "" : "s", fmt::join(found.at[k], ", "));
    }
    text += '\n';
  }
  if (found.vertices.size() > most_listed)
    text += fmt::format("    and {} more\n", found.vertices.size() - most_listed);
  return text + fmt::format("  bounding  {}\n", count_of(found.bounding.size(), "half-space"));
}

Json json_of(const RegionVertices& answer) {
  Json json{{"kind", name_of(answer.region.verdict())}};
  if (const auto* extent = extent_of(answer.region)) json["dimension"] = extent->dimension;
  json["bounding"] = answer.found.bounding;
  json["vertices"] = Json::array();
  for (std::size_t k = 0; k < answer.found.vertices.size(); ++k) {
    json["vertices"].push_back({{"point", fractions_of(answer.found.vertices[k])},
                                {"point_about", about(answer.found.vertices[k])},
                                {"half_spaces", answer.found.at[k]}});
  }
  return json;
}

}  // namespace

Report run_half_space_hull(const HullCall& call, Talk& talk, const polytope::Polytope& half_spaces,
                           const InputFiles& inputs) {
  const RegionVertices answer = region_vertices(half_spaces);
  const polytope::RegionExtent* const extent = extent_of(answer.region);
  const bool is_bounded = answer.region.verdict() == RegionKind::bounded;
  const std::string file = io::one_line(call.file);
  const std::string name = io::one_line(std::filesystem::path(call.file).stem().string());
  const bool is_written = !call.out.empty() && is_bounded;
  if (is_written) talk.write_file(call.out, table_of(answer.found, half_spaces.dimension()));
  if (!call.certificate.empty()) {
    write_proof(talk, call.certificate, {inputs, {}}, [&](ClaimsWriter& claims) {
      claims.say(said_of_file(Said::Source::half_spaces, inputs, call.file));
      add_claims(claims, name, half_spaces, answer);
    });
  }
  Report report{.verb = "hull",
                .answer = is_bounded ? name_of_hull(extent->dimension) : name_of(answer.region.verdict()),
                .code = is_bounded ? exit_code::no : exit_code::yes,
                .function = "polytope::region_vertices"};
  report.notes = talk.notes();
  report.objects.push_back(object_of(call, half_spaces));
  report.tell(fmt::format("{}: {} of dimension {}: ", file, count_of(half_spaces.size(), "half-space"),
                          half_spaces.dimension()));
  report.add("region", json_of(answer),
             is_bounded          ? text_of(answer)
             : extent == nullptr ? "empty: they contradict each other\n"
                                 : fmt::format("unbounded, of dimension {}: no hull of points\n", extent->dimension));
  add_files(call, is_written ? call.out : "", report);
  return report;
}

}  // namespace sunder::ask
