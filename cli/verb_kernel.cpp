// sunder kernel FILE: from which points of a polygon are all of its points seen?
#include <cli/common.h>
#include <cli/left_out.h>
#include <cli/list_stream.h>
#include <cli/plane_picture.h>
#include <cli/polygons_input.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/planar/region/kernel.h>
#include <sunder/planar/region/regions_json.h>
#include <sunder/predicate/constraints.h>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace sunder::cli {

namespace {

using planar::PolygonSides;
using planar::Region;
using planar::RegionKind;

struct Call {
  std::string file, feature, name;
  std::string method = "automatic";
  std::string certificate, svg, title;
  std::uint64_t svg_limit = most_drawn;  // edges
  bool drop_z = false, leave_out = false, skip_invalid = false, mend = false;
  bool json = false;
};

using KernelMethod = Region(const PolygonSides&, const planar::RegionOptions&);
KernelMethod* kernel_method(const std::string& name) {
  if (name == "automatic") return planar::kernel;
  if (name == "half-planes") return planar::kernel_by_half_plane_intersection;
  if (name == "lee-preparata") return planar::kernel_by_lee_preparata;
  if (name == "scan") return planar::kernel_by_scan;
  refuse_method(name, "automatic, half-planes, lee-preparata, scan");
}

struct Result {
  std::uint32_t polygon = 0;
  Region kernel;
  std::vector<Point2> corners;
};

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

std::string edge_text(const planar::Polygon& polygon, std::uint32_t k) {
  const planar::Segment e = polygon.edge(k);
  return fmt::format("edge {}: {} to {}", k, about(e.a), about(e.b));
}

constexpr std::size_t most_listed = 12;

std::string human_text(const Call& call, const PolygonsInput& input, const std::vector<Result>& results) {
  std::string text;
  std::size_t seen = 0;
  for (const Result& result : results) {
    const planar::Polygon& polygon = input.polygons[result.polygon];
    text += fmt::format("feature {}: ", input.name(result.polygon));
    if (result.kernel.empty()) {
      text += "no kernel: no point sees the inner sides of these edges\n";
      for (const std::uint32_t k : result.kernel.sides) text += "  " + edge_text(polygon, k) + "\n";
      continue;
    }
    ++seen;
    const char* const shape = result.kernel.kind == RegionKind::point     ? "one point"
                              : result.kernel.kind == RegionKind::segment ? "a segment"
                                                                          : "a convex polygon";
    text += fmt::format("the kernel is {} of {}\n", shape, count_of(result.corners.size(), "corner"));
    for (std::size_t k = 0; k < std::min(result.corners.size(), most_listed); ++k) {
      text += fmt::format("  corner at about {}\n", about(result.corners[k]));
    }
    if (result.corners.size() > most_listed) {
      text += fmt::format("  and {} more; --json has all\n", result.corners.size() - most_listed);
    }
  }
  const std::string without = input.left_out_words();
  text +=
      fmt::format("{}: {} of {} {} a kernel{}\n", io::one_line(call.file), seen, count_of(results.size(), "polygon"),
                  results.size() == 1 ? "has" : "have", without.empty() ? "" : ", said of these only: " + without);
  text += input.tell();
  if (!call.certificate.empty()) text += fmt::format("  proof       {}\n", io::one_line(call.certificate));
  if (!call.svg.empty()) text += fmt::format("  picture     {}\n", io::one_line(call.svg));
  return text;
}

Json report(const Call& call, const PolygonsInput& input, const std::vector<Result>& results, bool all) {
  Json json = envelope("kernel", all ? "feasible" : "infeasible", call.method);
  Cost cost;
  json["objects"] = Json::array();
  for (const Result& result : results) {
    cost.probes += result.kernel.cost.probes;
    cost.exact += result.kernel.cost.exact;
    const PolygonSource& source = input.source[result.polygon];
    Json object = {{"file", io::one_line(call.file)},
                   {"feature", source.feature},
                   {"name", input.name(result.polygon)},
                   {"part", source.part},
                   {"kind", name_of(result.kernel.kind)},
                   {"sides", result.kernel.sides},
                   {"corners", Json::array()}};
    for (const Point2& p : result.corners) object["corners"].push_back({{"point", {p.x, p.y}}});
    json["objects"].push_back(object);
  }
  json["cost"] = to_json(cost);
  input.tell(json);
  return json;
}

std::string picture(const Call& call, const PolygonsInput& input, const std::vector<Result>& results) {
  std::vector<Point2> seen;
  for (const Result& result : results) {
    const auto& vertices = input.polygons[result.polygon].vertices();
    seen.insert(seen.end(), vertices.begin(), vertices.end());
  }
  PlanePicture drawing(seen);
  for (const Result& result : results) {
    const planar::Polygon& polygon = input.polygons[result.polygon];
    drawing.polygon(polygon.vertices(), Ink::calm);
    if (result.kernel.empty()) {
      for (const std::uint32_t k : result.kernel.sides) {
        drawing.segment(polygon.edge(k).a, polygon.edge(k).b, Ink::accent);
      }
      continue;
    }
    drawing.polygon(result.corners, Ink::bold);
    for (const Point2& p : result.corners) drawing.dot(p, Ink::bold);
  }
  drawing.legend(Ink::bold, "sees all of the polygon");
  drawing.legend(Ink::accent, "edges that no point sees together");
  return drawing.text(call.title.empty() ? "From where is all of it seen?" : call.title,
                      count_of(results.size(), "polygon"));
}

int run(const Call& call) {
  KernelMethod* const method = kernel_method(call.method);
  PolygonsRequest request;
  request.files = {call.file};
  request.drop_z = call.drop_z;
  request.leave_out = call.leave_out;
  request.skip_invalid = call.skip_invalid;
  request.mend = call.mend;
  request.by_part = true;
  request.rule = planar::PolygonRule::simple;
  request.name = call.name;
  request.tell_inputs = !call.certificate.empty();
  const PolygonsInput input = read_polygons(request);
  std::vector<Result> results;
  std::string certificate;
  std::uint64_t edges = 0;  // of the polygons asked about
  for (std::uint32_t i = 0; i < input.polygons.size(); ++i) {
    if (!call.feature.empty() && input.name(i) != call.feature) continue;
    if (input.polygons[i].ring_count() > 1) {
      io::fail_file(call.file,
                    fmt::format("feature {}: has holes, so no kernel; give its outer ring alone", input.name(i)));
    }
    edges += input.polygons[i].size();
    const PolygonSides sides(input.polygons[i]);
    results.push_back({i, method(sides, {!call.certificate.empty()}), {}});
    Result& result = results.back();
    if (!result.kernel.empty()) {
      for (const auto& [j, k] : corners(result.kernel)) {
        result.corners.push_back(nearest(exact_corner(sides[j], sides[k])));
      }
    }
    if (call.certificate.empty()) continue;
    if (results.size() > 1) {
      throw Error(ErrorCode::bad_call, "a proof is about one polygon; name it by --feature", "--certificate");
    }
    Origin origin = input.origin();
    if (input.mended.empty()) origin.left_out.clear();  // a proof about one polygon speaks of no others
    certificate = planar::certificate_text(sides, result.kernel, origin);
  }
  if (results.empty()) {
    throw Error(ErrorCode::bad_call, fmt::format("{} has no polygon named {}", call.file, io::quote(call.feature)),
                "--feature");
  }
  if (!call.svg.empty()) require_drawable(edges, "edge", 0, call.svg_limit);
  if (!call.certificate.empty()) io::write_file_atomically(call.certificate, certificate);
  if (!call.svg.empty()) io::write_file_atomically(call.svg, picture(call, input, results));
  const bool all = std::none_of(results.begin(), results.end(), [](const Result& r) { return r.kernel.empty(); });
  call.json ? print(to_text(report(call, input, results, all))) : print_for_people(human_text(call, input, results));
  return all ? exit_code::no : exit_code::yes;
}

}  // namespace

void add_kernel(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb =
      program.add_subcommand("kernel", "From which points of a simple polygon are all of its points seen?");
  verb->add_option("FILE", call->file, "simple polygons without holes: WKT, GeoJSON")->required();
  verb->add_option("--feature", call->feature, "this polygon only")->type_name("NAME");
  verb->add_option("--name", call->name, name_help)->type_name("FIELD");
  verb->add_flag("--skip-invalid", call->skip_invalid, skip_invalid_help);
  verb->add_flag("--mend", call->mend, mend_help);
  verb->add_flag("--leave-out", call->leave_out, leave_out_help);
  verb->add_option("--method", call->method, "automatic, half-planes, lee-preparata, or scan")->type_name("NAME");
  verb->add_option("--certificate", call->certificate, "write the proof here")->type_name("FILE");
  auto* svg = verb->add_option("--svg", call->svg, "draw the polygons and their kernels here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  add_svg_limit(*verb, call->svg_limit);
  verb->add_flag("--drop-z", call->drop_z, "ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
