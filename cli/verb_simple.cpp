// sunder simple FILE: are the polygons of a file valid? If not, what is wrong, and where?
#include <cli/common.h>
#include <cli/left_out.h>
#include <cli/list_stream.h>
#include <cli/polygon_defect_text.h>
#include <cli/polygon_mend.h>
#include <cli/polygons_input.h>
#include <cli/segments_picture.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/lines.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/polygon_valid.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace sunder::cli {

namespace {

using planar::PolygonDefect;
using planar::PolygonDefects;
using planar::PolygonRings;
using planar::PolygonRule;
using planar::RingPlace;

struct Call {
  std::string file;
  std::string method = "automatic";
  std::string geojson, svg, title;
  std::uint64_t svg_limit = most_drawn;  // segments
  bool strict = false, self_touch = false;
  bool all = false;
  bool drop_z = false, leave_out = false, mend = false;
  bool json = false;

  PolygonRule rule() const {
    return strict ? PolygonRule::simple : self_touch ? PolygonRule::self_touch : PolygonRule::valid;
  }
  bool lists() const { return all || !geojson.empty() || !svg.empty(); }
  std::string answer(bool yes) const { return fmt::format("{}{}", yes ? "" : "not ", strict ? "simple" : "valid"); }
};

// A feature: its polygons are the parts of one.
struct Result {
  std::uint32_t feature = 0, line = 0;
  std::vector<std::vector<std::uint32_t>> rings;  // of each part, as positions among the rings of the file
  std::uint64_t edges = 0;
  MendedRings mended;
  PolygonDefects answer;

  bool has_parts() const { return rings.size() > 1; }
};

PolygonDefects answer_by(const Call& call, std::span<const PolygonRings> parts) {
  planar::ValidOptions options{call.rule()};
  if (!call.lists()) options.most = 1;
  if (call.method == "automatic") return polygon_defects(parts, options);
  if (call.method == "scan") return polygon_defects_by_scan(parts, options);
  refuse_method(call.method, "automatic, scan");
}

std::vector<Result> answers(const Call& call, const io::LineFile& file) {
  std::vector<Result> results;
  const auto feature_of = [&](std::uint32_t r) { return file.source[file.rings[r].first].feature; };
  for (std::uint32_t r = 0; r < file.rings.size();) {
    Result& result = results.emplace_back();
    result.feature = feature_of(r);
    result.line = file.source[file.rings[r].first].line;
    std::vector<PolygonRings> parts;
    for (const std::uint32_t first = r; r < file.rings.size() && feature_of(r) == result.feature; ++r) {
      const io::LineRing& ring = file.rings[r];
      if (r == first || file.rings[r - 1].polygon != ring.polygon) {
        parts.emplace_back();
        result.rings.emplace_back();
      }
      result.rings.back().push_back(r);
      result.edges += ring.count;
      std::vector<Point2>& points = parts.back().emplace_back();
      for (std::uint32_t k = 0; k < ring.count; ++k) points.push_back(file.segments[ring.first + k].a);
      points.push_back(Point2{points.front()});  // as in the file
    }
    if (call.mend) {
      for (PolygonRings& part : parts) result.mended += mend(part);
      std::erase_if(parts, [](const PolygonRings& part) { return part.empty(); });
    }
    result.answer = answer_by(call, parts);
  }
  return results;
}

std::string feature_text(const io::LineFile& file, const Result& result) {
  const std::string number = std::to_string(result.feature + 1), &name = file.features[result.feature];
  return fmt::format("feature {}{}{}", number, name == number ? "" : fmt::format(" ({})", name),
                     result.line > 0 ? fmt::format(", line {}", result.line) : "");
}

std::uint64_t valid_count(const std::vector<Result>& results) {
  return static_cast<std::uint64_t>(
      std::count_if(results.begin(), results.end(), [](const Result& r) { return r.answer.valid(); }));
}

LeftOutList left_out_of(const io::LineFile& file) {
  LeftOutList list(true);  // the reader refuses what the caller does not let go
  list.add("", file.left_out, "");
  return list;
}

constexpr std::size_t most_listed = 20;  // of a feature, and features

std::string human_text(const Call& call, const io::LineFile& file, const std::vector<Result>& results) {
  std::string text;
  std::uint64_t edges = 0, listed = 0, mended = 0;
  const std::uint64_t valid = valid_count(results);
  for (const Result& result : results) {
    edges += result.edges;
    if (result.mended.all() > 0 && ++mended <= most_listed) {
      text += fmt::format("{}: mended: {}\n", feature_text(file, result), text_of(result.mended));
    }
    const std::vector<PolygonDefect>& defects = result.answer.defects;
    if (defects.empty() || ++listed > most_listed) continue;
    text += fmt::format("{}: {}\n", feature_text(file, result), call.answer(false));
    for (std::size_t k = 0; k < std::min(defects.size(), most_listed); ++k) {
      text += fmt::format("  {:16}{}\n", name_of(defects[k].kind), text_of(defects[k], result.has_parts()));
    }
    if (defects.size() > most_listed) {
      text += fmt::format("  and {} more; --json or --geojson have all\n", defects.size() - most_listed);
    }
  }
  if (listed > most_listed) {
    text += fmt::format("and {} more; --json or --geojson have all\n", count_of(listed - most_listed, "feature"));
  }
  text += fmt::format("{}: {} of {} {}, {}, {}\n", io::one_line(call.file), valid, count_of(results.size(), "feature"),
                      call.answer(true), count_of(edges, "edge"), file.format);
  if (valid < results.size() && !call.lists()) text += "one defect of each is named; --all lists all\n";
  if (mended > 0) text += fmt::format("said of what was mended: {}\n", count_of(mended, "feature"));
  const LeftOutList left_out = left_out_of(file);
  if (!left_out.empty()) text += fmt::format("left out: {}\n", left_out.text());
  for (const std::string& remark : file.remarks) text += fmt::format("remark: {}\n", remark);
  return text;
}

Json place_json(const RingPlace& place) { return {{"part", place.part}, {"ring", place.ring}, {"edge", place.edge}}; }

Json defect_json(const PolygonDefect& defect, bool has_parts) {
  return {{"kind", name_of(defect.kind)},
          {"what", text_of(defect, has_parts)},
          {"places", {place_json(defect.a), place_json(defect.b)}}};
}

Json point_json(const Point2& p) { return Json::array({p.x, p.y}); }

Json report(const Call& call, const io::LineFile& file, const std::vector<Result>& results) {
  Json json = envelope("simple", call.answer(valid_count(results) == results.size()), call.method);
  Cost cost;
  json["rule"] = call.strict ? "simple" : call.self_touch ? "self-touch" : "valid";
  if (!file.left_out.empty()) json["left_out"] = left_out_of(file).json();
  json["objects"] = Json::array();
  for (const Result& result : results) {
    cost.probes += result.answer.cost.probes;
    std::size_t rings = 0;
    for (const std::vector<std::uint32_t>& part : result.rings) rings += part.size();
    Json object = {{"file", call.file},
                   {"feature", result.feature},
                   {"name", file.features[result.feature]},
                   {"parts", result.rings.size()},
                   {"rings", rings},
                   {"edges", result.edges},
                   {"answer", call.answer(result.answer.valid())},
                   {"defects", Json::array()}};
    if (result.mended.all() > 0) object["mended"] = to_json(result.mended);
    for (const PolygonDefect& defect : result.answer.defects) {
      Json entry = defect_json(defect, result.has_parts());
      entry["at"] = Json::array({point_json(defect.place.a)});
      if (defect.place.a != defect.place.b) entry["at"].push_back(point_json(defect.place.b));
      object["defects"].push_back(entry);
    }
    json["objects"].push_back(object);
  }
  json["cost"] = to_json(cost);
  return json;
}

// Each defect as a point, or a line where a piece is in common; a line of the text for each.
std::string defects_geojson(const io::LineFile& file, const std::vector<Result>& results) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  bool is_first = true;
  for (const Result& result : results) {
    for (const PolygonDefect& defect : result.answer.defects) {
      const auto& [a, b] = defect.place;
      Json geometry = {{"type", "Point"}, {"coordinates", point_json(a)}};
      if (a != b) geometry = {{"type", "LineString"}, {"coordinates", {point_json(a), point_json(b)}}};
      Json properties = {{"feature", result.feature}, {"name", file.features[result.feature]}};
      properties.update(defect_json(defect, result.has_parts()));
      const Json feature = {{"type", "Feature"}, {"geometry", geometry}, {"properties", properties}};
      text += is_first ? "\n" : ",\n";
      text += feature.dump(-1, ' ', false, Json::error_handler_t::replace);
      is_first = false;
    }
  }
  return text + "\n]}\n";
}

// Those defects that are two edges with a common point.
std::string picture(const Call& call, const io::LineFile& file, const std::vector<Result>& results) {
  const planar::Segments segments(file.segments);
  std::vector<planar::SegmentsContact> contacts;
  for (const Result& result : results) {
    const auto edge = [&](const RingPlace& place) {
      return file.rings[result.rings[place.part][place.ring]].first + place.edge;
    };
    for (const PolygonDefect& defect : result.answer.defects) {
      const std::uint32_t i = std::min(edge(defect.a), edge(defect.b)), j = std::max(edge(defect.a), edge(defect.b));
      const planar::ContactKind kind = segment_segment(segments[i], segments[j]);
      if (i != j && kind != planar::ContactKind::none) contacts.push_back({i, j, kind});
    }
  }
  const std::string title = call.title.empty() ? "Are these polygons " + call.answer(true) + "?" : call.title;
  return segments_svg({file, segments, contacts, title});
}

int run(const Call& call) {
  io::LineOptions options;
  options.drop_z = call.drop_z;
  options.leave_out = call.leave_out;
  options.lines = false;
  const io::LineFile file = io::read_lines(call.file, options);
  if (file.rings.empty()) io::fail_file(call.file, "has no polygons");
  if (!call.svg.empty()) require_drawable(file.segments.size(), "segment", 0, call.svg_limit);
  const std::vector<Result> results = answers(call, file);
  if (!call.geojson.empty()) io::write_file_atomically(call.geojson, defects_geojson(file, results));
  if (!call.svg.empty()) io::write_file_atomically(call.svg, picture(call, file, results));
  call.json ? print(to_text(report(call, file, results))) : print_for_people(human_text(call, file, results));
  return valid_count(results) == results.size() ? exit_code::no : exit_code::yes;
}

}  // namespace

void add_simple(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb = program.add_subcommand(
      "simple", "Are the polygons of a file valid, or simple? If not, what is wrong, and where?");
  verb->add_option("FILE", call->file, "polygons: WKT, GeoJSON, or JSON that is a list of rings")->required();
  verb->add_flag("--all", call->all, "list all defects of all features (unless told otherwise, one of each)");
  auto* strict = verb->add_flag("--strict", call->strict, "no vertex repeated, no two rings with a common point");
  verb->add_flag("--self-touch", call->self_touch, "a ring may touch itself in points")->excludes(strict);
  verb->add_option("--method", call->method, "automatic, or scan")->type_name("NAME");
  verb->add_option("--geojson", call->geojson, "write all defects here, as points and lines")->type_name("FILE");
  auto* svg = verb->add_option("--svg", call->svg, "draw the polygons and the edges that meet here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  verb->add_flag("--leave-out", call->leave_out, leave_out_help);
  verb->add_flag("--mend", call->mend, "ask about what is left without repeated vertices, spikes, rings without area")
      ->excludes(svg);
  add_svg_limit(*verb, call->svg_limit);
  verb->add_flag("--drop-z", call->drop_z, "ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
