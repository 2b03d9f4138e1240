// sunder simple FILE: are the polygons of a file valid? If not, what is wrong, and where?
#include <sunder/ask/left_out.h>
#include <sunder/ask/list_stream.h>
#include <sunder/ask/report.h>
#include <sunder/ask/set/polygon_defect_text.h>
#include <sunder/ask/set/polygon_parts.h>
#include <sunder/ask/set/polygons_input.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/certificate/claims.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/file.h>
#include <sunder/io/lines.h>
#include <sunder/io/text.h>
#include <sunder/picture/segments.h>
#include <sunder/planar/set/polygon_valid.h>
#include <sunder/planar/set/polygon_valid_json.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace sunder::ask {

namespace {

using planar::PolygonDefect;
using planar::PolygonDefects;
using planar::PolygonRings;
using planar::PolygonRule;
using planar::RingPlace;

struct Call {
  std::string file, name;
  std::string method = "automatic";
  std::string certificate, geojson, svg, title;
  std::uint64_t svg_limit = most_drawn;  // segments and defects
  bool strict = false, self_touch = false;
  bool all = false;
  bool drop_z = false, leave_out = false, skip_invalid = false, mend = false;
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
  std::vector<std::uint32_t> rings_of_part;
  std::uint32_t first_ring = 0;  // of the file; they follow each other
  std::uint64_t edges = 0;
  MendedRings mended;
  std::string skipped;      // why
  std::uint64_t count = 0;  // of defects
  Cost cost;
  std::optional<std::vector<PolygonDefect>> held;  // the defects, unless they are too many: then they are found again

  bool has_parts() const { return rings_of_part.size() > 1; }
  bool valid() const { return count == 0; }
};

constexpr std::size_t most_held = 1 << 16;  // defects, of all features
using VisitDefects = std::function<void(const planar::PolygonDefectVisitor&)>;

Cost visit_by(const Call& call, std::span<const PolygonRings> parts, const planar::PolygonDefectVisitor& visit) {
  planar::ValidOptions options{call.rule()};
  if (call.method == "automatic" && call.lists()) return visit_polygon_defects(parts, options, visit);
  if (!call.lists()) options.most = 1;
  const PolygonDefects answer =
      call.method == "scan" ? polygon_defects_by_scan(parts, options) : polygon_defects(parts, options);
  static_cast<void>(std::all_of(answer.defects.begin(), answer.defects.end(), visit));
  return answer.cost;
}

// The parts of the next feature, mended where that is wanted.
Result next_of(const Call& call, PartsReader& reader, Parts& parts) {
  Result result;
  if (!reader.next(parts)) return result;
  result.feature = parts.feature;
  result.line = parts.line;
  result.first_ring = parts.first_ring;
  for (const PolygonRings& part : parts.rings) {
    result.rings_of_part.push_back(static_cast<std::uint32_t>(part.size()));
    for (const std::vector<Point2>& ring : part) result.edges += ring.size() - (ring.front() == ring.back() ? 1 : 0);
  }
  if (call.mend) result.mended = mend(parts);
  result.skipped = parts.broken;
  return result;
}

std::vector<Result> answers(const Call& call, const io::LineFile& file) {
  std::vector<Result> results;
  PartsReader reader(file);
  std::size_t held = 0;
  for (Parts parts;;) {
    Result result = next_of(call, reader, parts);
    if (result.rings_of_part.empty()) return results;
    if (result.skipped.empty()) {
      std::vector<PolygonDefect> defects;
      result.cost = visit_by(call, parts.rings, [&](const PolygonDefect& defect) {
        ++result.count;
        if (held + result.count <= most_held) defects.push_back(defect);
        return true;
      });
      if (defects.size() == result.count) {
        held += defects.size();
        result.held = std::move(defects);
      }
    }
    results.push_back(std::move(result));
  }
}

// Calls for each feature that was asked about, with what visits its defects, in their order, once.
void for_each_feature(const Call& call, const io::LineFile& file, const std::vector<Result>& results,
                      const std::function<void(const Result&, const VisitDefects&)>& of_feature) {
  PartsReader reader(file);
  Parts parts;
  for (const Result& result : results) {
    next_of(call, reader, parts);
    if (!result.skipped.empty()) continue;
    of_feature(result, [&](const planar::PolygonDefectVisitor& visit) {
      if (result.held) {
        static_cast<void>(std::all_of(result.held->begin(), result.held->end(), visit));
      } else {
        visit_by(call, parts.rings, visit);
      }
    });
  }
}

// Calls for each feature that was asked about and has parts, with these.
void for_each_parts(const Call& call, const io::LineFile& file, const std::vector<Result>& results,
                    const std::function<void(const Result&, std::span<const PolygonRings>)>& of_feature) {
  PartsReader reader(file);
  Parts parts;
  for (const Result& result : results) {
    next_of(call, reader, parts);
    if (result.skipped.empty() && !parts.rings.empty()) of_feature(result, parts.rings);
  }
}

std::string feature_text(const io::LineFile& file, const Result& result) {
  const std::string number = std::to_string(result.feature + 1), &name = file.features[result.feature];
  return fmt::format("feature {}{}{}", number, name == number ? "" : fmt::format(" ({})", name),
                     result.line > 0 ? fmt::format(", line {}", result.line) : "");
}

struct Counts {
  std::uint64_t asked = 0, valid = 0, edges = 0, mended = 0, skipped = 0, defects = 0;
  Cost cost;
};

Counts counts_of(const std::vector<Result>& results) {
  Counts counts;
  for (const Result& result : results) {
    counts.edges += result.edges;
    if (!result.skipped.empty()) {
      ++counts.skipped;
      continue;
    }
    ++counts.asked;
    if (result.valid()) ++counts.valid;
    if (result.mended.all() > 0) ++counts.mended;
    counts.defects += result.count;
    counts.cost.probes += result.cost.probes;
  }
  return counts;
}

LeftOutList left_out_of(const io::LineFile& file) {
  LeftOutList list(true);  // the reader refuses what the caller does not let go
  list.add("", file.left_out, "");
  return list;
}

// What the certificate is of, what it does not speak of, and what was changed before.
Origin origin_of(const Counts& counts, const LeftOutList& left_out, const InputFiles& inputs) {
  Origin origin{inputs, {}};
  if (counts.skipped > 0) {
    origin.left_out.push_back(fmt::format("skipped: {}", count_of(counts.skipped, "invalid feature")));
  }
  for (const std::string& text : left_out.texts()) origin.left_out.push_back(text);
  if (counts.mended > 0) origin.left_out.push_back(fmt::format("mended: {}", count_of(counts.mended, "feature")));
  return origin;
}

constexpr std::uint64_t most_proved = 10'000'000;  // defects

// Writes a statement for each feature that is valid, and for each defect that is listed.
void prove(const Call& call, const io::LineFile& file, const std::vector<Result>& results, const InputFiles& inputs) {
  const Counts counts = counts_of(results);
  if (counts.defects > most_proved) {
    throw Error(ErrorCode::bad_call,
                fmt::format("{} defects, and their proofs would have about {:.1f} GB; leave out --all", counts.defects,
                            static_cast<double>(counts.defects) * 150 / 1e9),
                "--certificate");
  }
  io::OutputFile out(call.certificate);
  ClaimsWriter claims([&](std::string_view text) { out.write(text); });
  claims.add_origin(origin_of(counts, left_out_of(file), inputs));
  claims.begin_table("polygons");
  for_each_parts(call, file, results, [&](const Result&, const auto& parts) { planar::write_parts(claims, parts); });
  claims.end_table();
  std::uint32_t first = 0;
  for_each_parts(call, file, results, [&](const Result& result, std::span<const PolygonRings> parts) {
    const auto prove_defect = [&](const PolygonDefect& defect) {
      if (!planar::write_defect(claims, parts, first, call.rule(), defect)) {
        throw Error(ErrorCode::bad_call,
                    fmt::format("{}: one of its defects, {}, has no proof here; leave it out",
                                feature_text(file, result), text_of(defect, result.has_parts())),
                    "--certificate");
      }
      return true;
    };
    if (result.valid()) {
      planar::write_valid(claims, parts, first, call.rule());
    } else if (result.held) {
      static_cast<void>(std::all_of(result.held->begin(), result.held->end(), prove_defect));
    } else {
      visit_by(call, parts, prove_defect);
    }
    first += static_cast<std::uint32_t>(parts.size());
  });
  claims.end();
  out.commit();
}

constexpr std::size_t most_listed = 20;  // of a feature, and features

// The first defects of a feature.
std::string defects_text(const Call& call, const io::LineFile& file, const Result& result, const VisitDefects& visit) {
  std::string text = fmt::format("{}: {}\n", feature_text(file, result), call.answer(false));
  std::size_t listed = 0;
  visit([&](const PolygonDefect& defect) {
    text += fmt::format("  {:16}{}\n", name_of(defect.kind), text_of(defect, result.has_parts()));
    return ++listed < most_listed;
  });
  if (result.count > listed) {
    text += fmt::format("  and {} more; --json or --geojson have all\n", result.count - listed);
  }
  return text;
}

std::string human_text(const Call& call, const io::LineFile& file, const std::vector<Result>& results) {
  std::string text;
  const Counts counts = counts_of(results);
  std::uint64_t listed = 0, mended = 0, skipped = 0;
  for_each_feature(call, file, results, [&](const Result& result, const VisitDefects& visit) {
    if (result.mended.all() > 0 && ++mended <= most_listed) {
      text += fmt::format("{}: mended: {}\n", feature_text(file, result), text_of(result.mended));
    }
    if (!result.valid() && ++listed <= most_listed) text += defects_text(call, file, result, visit);
  });
  if (listed > most_listed) {
    text += fmt::format("and {} more; --json or --geojson have all\n", count_of(listed - most_listed, "feature"));
  }
  for (const Result& result : results) {
    if (result.skipped.empty() || ++skipped > most_listed) continue;
    text += fmt::format("{}: skipped: {}\n", feature_text(file, result), result.skipped);
  }
  if (skipped > most_listed) text += fmt::format("and {} more skipped; --json has all\n", skipped - most_listed);
  text +=
      fmt::format("{}: {} of {} {}, {}, {}\n", io::one_line(call.file), counts.valid, count_of(counts.asked, "feature"),
                  call.answer(true), count_of(counts.edges, "edge"), file.format);
  if (counts.valid < counts.asked && !call.lists()) text += "one defect of each is named; --all lists all\n";
  if (counts.mended > 0) text += fmt::format("said of what was mended: {}\n", count_of(counts.mended, "feature"));
  if (skipped > 0) text += fmt::format("said of these only; skipped: {}\n", count_of(skipped, "invalid feature"));
  const LeftOutList left_out = left_out_of(file);
  if (!left_out.empty()) text += fmt::format("left out: {}\n", left_out.text());
  for (const std::string& remark : file.remarks) text += fmt::format("remark: {}\n", remark);
  if (!call.certificate.empty()) text += fmt::format("proof: {}\n", io::one_line(call.certificate));
  return text;
}

Json place_json(const RingPlace& place) { return {{"part", place.part}, {"ring", place.ring}, {"edge", place.edge}}; }

Json defect_json(const PolygonDefect& defect, bool has_parts) {
  return {{"kind", name_of(defect.kind)},
          {"what", text_of(defect, has_parts)},
          {"places", {place_json(defect.a), place_json(defect.b)}}};
}

Json point_json(const Point2& p) { return Json::array({p.x, p.y}); }

// All but the features, which are its objects.
Json report(const Call& call, const io::LineFile& file, const std::vector<Result>& results) {
  const Counts counts = counts_of(results);
  Json json = envelope("simple", call.answer(counts.valid == counts.asked), call.method);
  json["cost"] = to_json(counts.cost);
  json["rule"] = call.strict ? "simple" : call.self_touch ? "self-touch" : "valid";
  if (!file.left_out.empty()) json["left_out"] = to_json(left_out_of(file));
  for (const Result& result : results) {
    Json feature = {
        {"file", io::one_line(call.file)}, {"feature", result.feature}, {"name", file.features[result.feature]}};
    if (!result.skipped.empty()) {
      feature["why"] = result.skipped;
      json["skipped"].push_back(std::move(feature));
    } else if (result.mended.all() > 0) {
      feature.update(to_json(result.mended));
      json["mended"].push_back(std::move(feature));
    }
  }
  if (!file.remarks.empty()) json["remarks"] = file.remarks;
  return json;
}

// A feature in the report, all but its defects.
Json object_json(const Call& call, const io::LineFile& file, const Result& result) {
  return {{"file", io::one_line(call.file)},
          {"format", file.format},
          {"feature", result.feature},
          {"name", file.features[result.feature]},
          {"parts", result.rings_of_part.size()},
          {"rings", std::accumulate(result.rings_of_part.begin(), result.rings_of_part.end(), 0u)},
          {"edges", result.edges},
          {"answer", call.answer(result.valid())}};
}

// Prints the report, each feature and each defect as it comes.
void print_report(const Call& call, const io::LineFile& file, const std::vector<Result>& results) {
  ListReport objects(report(call, file, results), "objects");
  for_each_feature(call, file, results, [&](const Result& result, const VisitDefects& visit) {
    objects.add_list(object_json(call, file, result), "defects", [&](ListStream& defects) {
      visit([&](const PolygonDefect& defect) {
        Json entry = defect_json(defect, result.has_parts());
        entry["at"] = Json::array({point_json(defect.place.a)});
        if (defect.place.a != defect.place.b) entry["at"].push_back(point_json(defect.place.b));
        defects.add(to_line(entry));
        return true;
      });
    });
  });
  objects.close();
}

// Each defect as a point, or a line where a piece is in common; a line of the text for each.
void write_geojson(const Call& call, const io::LineFile& file, const std::vector<Result>& results) {
  GeojsonFile geojson(call.geojson);
  for_each_feature(call, file, results, [&](const Result& result, const VisitDefects& visit) {
    visit([&](const PolygonDefect& defect) {
      const auto& [a, b] = defect.place;
      Json geometry = {{"type", "Point"}, {"coordinates", point_json(a)}};
      if (a != b) geometry = {{"type", "LineString"}, {"coordinates", {point_json(a), point_json(b)}}};
      Json properties = {{"feature", result.feature}, {"name", file.features[result.feature]}};
      properties.update(defect_json(defect, result.has_parts()));
      const Json feature = {{"type", "Feature"}, {"geometry", geometry}, {"properties", properties}};
      geojson.add(feature.dump(-1, ' ', false, Json::error_handler_t::replace));
      return true;
    });
  });
  geojson.close();
}

// Those defects that are two edges with a common point.
std::string picture(const Call& call, const io::LineFile& file, const std::vector<Result>& results) {
  const planar::Segments segments(file.segments);
  std::vector<planar::SegmentsContact> contacts;
  for_each_feature(call, file, results, [&](const Result& result, const VisitDefects& visit) {
    const auto edge = [&](const RingPlace& place) {
      const auto parts = result.rings_of_part.begin();
      const std::uint32_t ring = std::accumulate(parts, parts + place.part, result.first_ring + place.ring);
      return file.rings[ring].first + place.edge;
    };
    visit([&](const PolygonDefect& defect) {
      const std::uint32_t i = std::min(edge(defect.a), edge(defect.b)), j = std::max(edge(defect.a), edge(defect.b));
      const planar::ContactKind kind = segment_segment(segments[i], segments[j]);
      if (i != j && kind != planar::ContactKind::none) contacts.push_back({i, j, kind});
      return true;
    });
  });
  const std::string title = call.title.empty() ? "Are these polygons " + call.answer(true) + "?" : call.title;
  return picture::segments_svg({file, segments, contacts, title});
}

io::LineFile read(const Call& call, InputFiles& inputs) {
  io::LineOptions options;
  if (!call.certificate.empty()) options.inputs = &inputs;
  options.drop_z = call.drop_z;
  options.leave_out = call.leave_out;
  options.lines = false;
  options.keep_broken = call.mend || call.skip_invalid;
  options.name = call.name;
  io::LineFile file = io::read_lines(call.file, options);
  if (file.rings.empty() && file.broken.empty()) io::fail_file(call.file, "has no polygons");
  return file;
}

int run(const Call& call) {
  if (call.method != "automatic" && call.method != "scan") refuse_method(call.method, "automatic, scan");
  InputFiles inputs;
  const io::LineFile file = read(call, inputs);
  const auto require_drawable = [&](std::uint64_t defects) {
    if (!call.svg.empty()) ask::require_drawable(file.segments.size(), "segment", defects, call.svg_limit);
  };
  require_drawable(0);
  const std::vector<Result> results = answers(call, file);
  const Counts counts = counts_of(results);
  require_drawable(counts.defects);
  if (counts.asked == 0) io::fail_file(call.file, "no polygon has all its rings, so nothing is left to ask about");
  if (!call.certificate.empty()) prove(call, file, results, inputs);
  if (!call.geojson.empty()) write_geojson(call, file, results);
  if (!call.svg.empty()) io::write_file_atomically(call.svg, picture(call, file, results));
  if (call.json) {
    print_report(call, file, results);
  } else {
    print_for_people(human_text(call, file, results));
  }
  return counts.valid == counts.asked ? exit_code::no : exit_code::yes;
}

}  // namespace

Verb simple_verb() {
  const auto call = std::make_shared<Call>();
  return {
      "simple",
      "Are the polygons of a file valid, or simple? If not, what is wrong, and where?",
      "0 all are valid; 1 some are not",
      {{"FILE", &call->file, "polygons: WKT, GeoJSON, or JSON that is a list of rings", "", true},
       {"--all", &call->all, "list all defects of all features (unless told otherwise, one of each)"},
       {"--strict", &call->strict, "no vertex repeated, no two rings with a common point"},
       {.name = "--self-touch",
        .value = &call->self_touch,
        .help = "a ring may touch itself in points",
        .excludes = {"--strict"}},
       {"--method", &call->method, "automatic, or scan", "NAME"},
       certificate_option(call->certificate, "write the proofs here, of defects those that are listed"),
       {"--geojson", &call->geojson, "write all defects here, as points and lines", "FILE"},
       {"--svg", &call->svg, "draw the polygons and the edges that meet here", "FILE"},
       title_option(call->title),
       {"--leave-out", &call->leave_out, leave_out_help},
       {"--name", &call->name, name_help, "FIELD"},
       {"--skip-invalid", &call->skip_invalid, "answer for the features whose rings are closed, and list the others"},
       {.name = "--mend",
        .value = &call->mend,
        .help = "close rings, and ask about what is left without repeated vertices, spikes, rings without area",
        .excludes = {"--svg"}},
       svg_limit_option(call->svg_limit),
       {"--drop-z", &call->drop_z, "ignore third coordinates"},
       json_option(call->json)},
      [call] { return run(*call); }};
}

}  // namespace sunder::ask
