#include <sunder/ask/hull_polytope.h>
#include <sunder/ask/objects.h>
#include <sunder/ask/report.h>
#include <sunder/ask/said_of.h>

#include <sunder/base/error.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/polytopes.h>
#include <sunder/io/text/text.h>
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/hull/hull_claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace sunder::ask {

namespace {

using polytope::ConvexHull;
using polytope::Polytope;

// A row a1, .., ad, b, so that a is of length 1, about.
std::vector<double> about_unit(const std::vector<Dyadic>& row) {
  std::int64_t top = 0;
  bool found = false;
  for (std::size_t c = 0; c + 1 < row.size(); ++c) {
    if (row[c].sign() == Sign::zero) continue;
    top = found ? std::max(top, row[c].top()) : row[c].top();
    found = true;
  }
  double square = 0;
  for (std::size_t c = 0; c + 1 < row.size(); ++c) square += std::pow(row[c].scaled(-top).nearest(), 2);
  const Dyadic length = Dyadic(std::sqrt(square)).scaled(top);
  std::vector<double> result;
  for (const Dyadic& x : row) result.push_back(nearest_ratio(x, length));
  return result;
}

// A line for each simplex: the facet, and the points.
std::string table_of(const ConvexHull& hull) {
  std::string text = "facet";
  for (std::size_t i = 1; i <= hull.dimension; ++i) text += fmt::format(",v{}", i);
  text += '\n';
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto simplices = hull.simplices(f);
    for (std::size_t k = 0; k < simplices.size(); k += hull.dimension) {
      text += fmt::format("{}", f);
      for (const std::uint32_t v : simplices.subspan(k, hull.dimension)) text += fmt::format(",{}", v);
      text += '\n';
    }
  }
  return text;
}

Json json_of(const Polytope& points, const ConvexHull& hull) {
  Json facets = Json::array(), equations = Json::array();
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto vertices = hull.facet_vertices(f);
    facets.push_back({{"vertices", std::vector<std::uint32_t>(vertices.begin(), vertices.end())},
                      {"simplices", hull.simplices(f).size() / hull.dimension},
                      {"half_space_about", about_unit(facet_half_space(hull, points, f))}});
  }
  for (const auto& row : flat_equations(hull, points)) equations.push_back(about_unit(row));
  return {{"dimension", hull.dimension},
          {"vertices", hull.vertices},
          {"facets", std::move(facets)},
          {"equations_about", std::move(equations)}};
}

}  // namespace

const char* name_of_hull(std::size_t dimension) {
  return dimension > 3 ? "polytope" : dimension_name(static_cast<int>(dimension));
}

void add_files(const HullCall& call, const std::string& out, Report& report) {
  report.add("out", out.empty() ? Json(nullptr) : Json(out),
             out.empty() ? "" : fmt::format("  written   {}\n", io::one_line(out)));
  report.is_proved = !call.certificate.empty();
  if (!report.is_proved) return;
  report.tell(fmt::format("  proof     {}\n", io::one_line(call.certificate)));
}

Json object_of(const HullCall& call, const Polytope& polytope) {
  return {{"file", io::one_line(call.file)},
          {"name", io::one_line(std::filesystem::path(call.file).stem().string())},
          {"format", std::filesystem::path(call.file).extension() == ".npy" ? "NPY" : "CSV"},
          {"shape", polytope.is_of_points() ? "points" : "half-spaces"},
          {"dimension", polytope.dimension()},
          {"rows", polytope.size()}};
}

Report run_polytope_hull(const HullCall& call, Talk& talk) {
  if (call.leave_out) throw Error(ErrorCode::bad_call, "is not for polytopes; leave it out", "--leave-out");
  const bool is_table = std::filesystem::path(call.out).extension() == ".csv";
  if (!call.out.empty() && !is_table) {
    throw Error(ErrorCode::bad_call, "of polytopes out of CSV or NPY facets and vertices are written as .csv", "--out");
  }
  InputFiles inputs;
  const Polytope points = io::read_polytope(call.file, call.certificate.empty() ? nullptr : &inputs,
                                            call.half_spaces ? polytope::Form::half_spaces : polytope::Form::points);
  if (!points.is_of_points()) return run_half_space_hull(call, talk, points, inputs);
  const std::string file = io::one_line(call.file);
  const ConvexHull hull = convex_hull(points);
  const std::string name = io::one_line(std::filesystem::path(call.file).stem().string());
  if (!call.out.empty()) talk.write_file(call.out, table_of(hull));
  if (!call.certificate.empty()) {
    write_proof(talk, call.certificate, {inputs, {}}, [&](ClaimsWriter& claims) {
      claims.say(said_of_file(Said::Source::points, inputs, call.file));
      write_hull(claims, name, points, hull);
    });
  }
  Report report{.verb = "hull", .answer = name_of_hull(hull.dimension)};
  report.notes = talk.notes();
  report.objects.push_back(object_of(call, points));
  report.tell(fmt::format("{}: hull of dimension {}: a {}\n", file, hull.dimension, name_of_hull(hull.dimension)));
  report.tell(fmt::format("  points    {}, of {} numbers\n", points.size(), points.dimension()));
  report.add("hull", json_of(points, hull),
             fmt::format("  vertices  {}\n  facets    {}{}\n", hull.vertices.size(), hull.facet_count(),
                         hull.simplex_count() > hull.facet_count()
                             ? fmt::format(", cut into {} simplices", hull.simplex_count())
                             : ""));
  add_files(call, call.out, report);
  return report;
}

}  // namespace sunder::ask
