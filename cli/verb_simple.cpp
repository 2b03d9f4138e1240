// sunder simple FILE: are the polygons of a file simple?
#include <cli/common.h>
#include <cli/segments_picture.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/lines.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/polygon_simple.h>

#include <fmt/format.h>

#include <memory>

namespace sunder::cli {

namespace {

using planar::Polygon;
using planar::PolygonSimpleAnswer;

struct Call {
  std::string file;
  std::string method = "automatic";
  std::string svg, title;
  bool drop_z = false;
  bool json = false;
};

struct Result {
  std::uint32_t first_ring = 0, feature = 0;
  Polygon polygon;
  PolygonSimpleAnswer answer;
};

PolygonSimpleAnswer answer_by(const std::string& method, const Polygon& polygon) {
  if (method == "automatic") return polygon_simple(polygon);
  if (method == "grid") return polygon_simple_by_grid(polygon);
  if (method == "sweep") return polygon_simple_by_sweep(polygon);
  if (method == "scan") return polygon_simple_by_scan(polygon);
  refuse_method(method, "automatic, grid, sweep, scan");
}

std::vector<Result> answers(const Call& call, const io::LineFile& file) {
  std::vector<Result> results;
  for (std::uint32_t r = 0; r < file.rings.size();) {
    const std::uint32_t first = r, number = file.rings[r].polygon;
    std::vector<std::vector<Point2>> rings;
    for (; r < file.rings.size() && file.rings[r].polygon == number; ++r) {
      std::vector<Point2>& ring = rings.emplace_back();
      for (std::uint32_t k = 0; k < file.rings[r].count; ++k) ring.push_back(file.segments[file.rings[r].first + k].a);
      ring.push_back(ring.front());  // as in the file: Polygon leaves out exactly this one
    }
    const std::uint32_t feature = file.source[file.rings[first].first].feature;
    try {
      const Polygon polygon(rings);
      results.push_back({first, feature, polygon, answer_by(call.method, polygon)});
    } catch (const Error& error) {
      if (error.code() == ErrorCode::bad_call) throw;
      io::fail_file(call.file, fmt::format("feature {}: {}", file.features[feature], error.what()));
    }
  }
  return results;
}

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

std::string edge_text(const io::LineFile& file, const Result& result, std::uint32_t k) {
  const std::uint32_t ring = result.polygon.ring_of(k);
  const planar::Segment edge = result.polygon.edge(k);
  const std::uint32_t line = file.source[file.rings[result.first_ring + ring].first].line;
  return fmt::format("ring {}, edge {}{}: {} to {}", ring, k - result.polygon.ring_begin(ring),
                     line > 0 ? fmt::format(", line {}", line) : "", about(edge.a), about(edge.b));
}

std::uint64_t edges_of_rings(const io::LineFile& file) {
  std::uint64_t edges = 0;
  for (const io::LineRing& ring : file.rings) edges += ring.count;
  return edges;
}

std::string human_text(const Call& call, const io::LineFile& file, const std::vector<Result>& results) {
  std::string text;
  std::uint64_t simple = 0, edges = 0;
  for (const Result& result : results) {
    edges += result.polygon.size();
    simple += result.answer.simple();
    if (result.answer.simple()) continue;
    text += fmt::format("feature {}: not simple: {}\n", file.features[result.feature], name_of(result.answer.kind));
    for (const std::uint32_t k : {result.answer.i, result.answer.j}) {
      text += "  " + edge_text(file, result, k) + "\n";
    }
  }
  text += fmt::format("{}: {} of {} simple, {}, {}\n", call.file, simple, count_of(results.size(), "polygon"),
                      count_of(edges, "edge"), file.format);
  const std::uint64_t others = file.segments.size() - edges_of_rings(file);
  if (others > 0) text += fmt::format("{} of lines passed over\n", count_of(others, "segment"));
  return text;
}

Json report(const Call& call, const io::LineFile& file, const std::vector<Result>& results, bool all) {
  Json json = envelope("simple", all ? "simple" : "not simple", call.method);
  Cost cost;
  json["objects"] = Json::array();
  for (const Result& result : results) {
    cost.probes += result.answer.cost.probes;
    Json object = {{"file", call.file},
                   {"feature", file.features[result.feature]},
                   {"rings", result.polygon.ring_count()},
                   {"edges", result.polygon.size()},
                   {"answer", result.answer.simple() ? "simple" : "not simple"}};
    if (!result.answer.simple()) {
      object["contact"] = {{"kind", name_of(result.answer.kind)}};
      for (const std::uint32_t k : {result.answer.i, result.answer.j}) {
        const std::uint32_t ring = result.polygon.ring_of(k);
        const planar::Segment e = result.polygon.edge(k);
        object["contact"]["edges"].push_back({{"ring", ring},
                                              {"edge", k - result.polygon.ring_begin(ring)},
                                              {"from", {e.a.x, e.a.y}},
                                              {"to", {e.b.x, e.b.y}}});
      }
    }
    json["objects"].push_back(object);
  }
  json["cost"] = to_json(cost);
  return json;
}

int run(const Call& call) {
  const io::LineFile file = io::read_lines(call.file, {call.drop_z, {}, nullptr});
  if (file.rings.empty()) io::fail_file(call.file, "has no polygons; for lines, ask sunder segments");
  const std::vector<Result> results = answers(call, file);
  bool all = true;
  for (const Result& result : results) all = all && result.answer.simple();
  if (!call.svg.empty()) {
    std::vector<planar::SegmentsContact> contacts;
    for (const Result& result : results) {
      if (result.answer.simple()) continue;
      const std::uint32_t first = file.rings[result.first_ring].first;  // rings of a polygon stand together
      contacts.push_back({first + result.answer.i, first + result.answer.j, result.answer.kind});
    }
    const planar::Segments segments(file.segments);
    io::write_file_atomically(call.svg, segments_svg({file, segments, contacts, call.title}));
  }
  print(call.json ? to_text(report(call, file, results, all)) : human_text(call, file, results));
  return all ? exit_code::no : exit_code::yes;
}

}  // namespace

void add_simple(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb = program.add_subcommand("simple", "Are the polygons of a file simple? If not, which edges meet?");
  verb->add_option("FILE", call->file, "polygons: WKT, GeoJSON, or JSON that is a list of rings")->required();
  verb->add_option("--method", call->method, "automatic, grid, sweep, or scan")->type_name("NAME");
  auto* svg = verb->add_option("--svg", call->svg, "draw the polygons and the edges named here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  verb->add_flag("--drop-z", call->drop_z, "ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
