// sunder simple FILE: are the polygons of a file valid? If not, what is wrong, and where?
#include <sunder/ask/list_stream.h>
#include <sunder/ask/mesh_memory_option.h>
#include <sunder/ask/report.h>
#include <sunder/ask/set/contact_row.h>
#include <sunder/ask/set/polygons_input.h>
#include <sunder/ask/set/set_verb.h>
#include <sunder/ask/simple_mesh.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/plane/polygon_parts.h>
#include <sunder/io/text/file.h>
#include <sunder/picture/segments.h>
#include <sunder/planar/polygons/polygon_valid.h>
#include <sunder/planar/polygons/polygon_valid_claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using planar::PolygonDefect;
using planar::PolygonDefectVisitor;
using planar::PolygonRings;
using planar::PolygonRule;
using planar::RingPlace;

struct SimpleCall : QuestionCall {  // svg_limit: of segments and defects
  std::string file, name, geojson;
  std::vector<std::string> properties;
  bool strict = false, self_touch = false;
  bool all = false;
  bool drop_z = false, leave_out = false, skip_invalid = false, mend = false, mixed_crs = false;

  PolygonRule rule() const {
    return strict ? PolygonRule::simple : self_touch ? PolygonRule::self_touch : PolygonRule::valid;
  }
  bool lists() const { return all || !geojson.empty() || !svg.empty(); }
  std::string answer(bool yes) const { return fmt::format("{}{}", yes ? "" : "not ", strict ? "simple" : "valid"); }
};

// A feature: its polygons are the parts of one.
struct SimpleResult {
  std::uint32_t feature = 0, line = 0;
  std::vector<std::uint32_t> rings_of_part;
  std::uint32_t first_ring = 0;  // of the file; they follow each other
  std::uint64_t edges = 0;
  planar::MendedRings mended;
  bool skipped = false;
  std::uint64_t count = 0;                         // of defects
  std::vector<io::OpenRing> open;                  // defects that come first: rings that do not end where they began
  std::optional<std::vector<PolygonDefect>> held;  // the others, unless they are too many: then they are found again

  bool has_parts() const { return rings_of_part.size() > 1; }
  bool valid() const { return count == 0; }
};

constexpr std::size_t most_held = 1 << 16;  // defects, of all features
constexpr std::size_t most_listed = 20;     // of a feature, and features

using VisitDefects = std::function<void(const PolygonDefectVisitor&)>;

Json place_json(const RingPlace& place) { return {{"part", place.part}, {"ring", place.ring}, {"edge", place.edge}}; }

std::string open_text(const io::OpenRing& open, bool has_parts) {
  return fmt::format("{}ring {} ends at {}, not where it began, at {}; asked about as if it did",
                     has_parts ? fmt::format("part {}, ", open.part) : "", open.ring, place_text(open.last),
                     place_text(open.first));
}

Json defect_json(const io::OpenRing& open, bool has_parts) {
  const Json place = place_json({open.part, open.ring, open.edge});
  return {{"kind", "open-ring"}, {"what", open_text(open, has_parts)}, {"places", {place, place}}};
}

Json at_json(const io::OpenRing& open) {
  return Json::array({Json::array({open.last.x, open.last.y}), Json::array({open.first.x, open.first.y})});
}

Json defect_json(const PolygonDefect& defect, bool has_parts) {
  return {{"kind", name_of(defect.kind)},
          {"what", text_of(defect, has_parts)},
          {"places", {place_json(defect.a), place_json(defect.b)}}};
}

// A point, or the ends of the piece that is in common.
Json at_json(const PolygonDefect& defect) {
  const auto& [a, b] = defect.place;
  Json at = Json::array();
  at.push_back({a.x, a.y});
  if (a != b) at.push_back({b.x, b.y});
  return at;
}

class ValidQuestion {
 public:
  ValidQuestion(const SimpleCall& call, Talk& talk) : call_(call), talk_(talk) {
    input_.systems = io::CoordinateSystems(call.mixed_crs);
    input_.read_file(call.file,
                     {.drop_z = call.drop_z,
                      .leave_out = call.leave_out,
                      .keep_broken = call.mend || call.skip_invalid || call.svg.empty(),
                      .name = call.name,
                      .properties = call.properties},
                     call.proves());
    if (file().rings.empty() && file().broken.empty()) io::fail_file(call.file, "has no polygons");
  }

  // Answers, and writes all that was asked for. Returns the exit code.
  int answer() {
    require_drawable();
    ask();
    require_drawable();
    if (asked_ == 0) io::fail_file(call_.file, "no polygon has all its rings, so nothing is left to ask about");
    if (call_.proves()) prove();
    talk_.note_all(input_.systems.remarks());
    if (!call_.geojson.empty()) write_geojson();
    if (!call_.svg.empty()) talk_.write_file(call_.svg, picture());
    call_.json ? print_report() : talk_.print_for_people(text());
    return valid_ == asked_ ? exit_code::no : exit_code::yes;
  }

 private:
  const io::LineFile& file() const { return input_.files.front(); }
  const std::string& name(const SimpleResult& result) const { return file().features[result.feature]; }

  // Those that --property asks for.
  void add_properties(const SimpleResult& result, Json& json) const {
    for (std::size_t k = 0; k < call_.properties.size(); ++k) {
      json["properties"][call_.properties[k]] = Json::written(value_json(file().properties[result.feature][k]));
    }
  }

  void require_drawable() const {
    if (!call_.svg.empty()) ask::require_drawable(file().segments.size(), "segment", defects_, call_.svg_limit);
  }

  CountAnswer<> visit_by_method(std::span<const PolygonRings> parts, const PolygonDefectVisitor& visit) const {
    planar::ValidOptions options{call_.rule()};
    if (call_.method == "automatic" && call_.lists()) return visit_polygon_defects(parts, options, visit);
    if (!call_.lists()) options.most = 1;
    const planar::PolygonDefects answer =
        call_.method == "scan" ? polygon_defects_by_scan(parts, options) : polygon_defects(parts, options);
    static_cast<void>(std::all_of(answer.found.begin(), answer.found.end(), visit));
    return {answer.found.size(), answer.cost};
  }

  void ask() {
    io::PolygonPartsReader reader(file());
    std::size_t held = 0;
    for (io::PolygonParts parts; reader.next(parts);) {
      SimpleResult& result = results_.emplace_back();
      result.feature = parts.feature;
      result.line = parts.line;
      result.first_ring = parts.first_ring;
      for (const PolygonRings& part : parts.rings) {
        result.rings_of_part.push_back(static_cast<std::uint32_t>(part.size()));
        for (const std::vector<Point2>& ring : part)
          result.edges += ring.size() - (ring.front() == ring.back() ? 1 : 0);
      }
      edges_ += result.edges;
      if (call_.mend) result.mended = mend(parts);
      if (result.mended.all() > 0) {
        input_.mended.push_back({0, result.feature, result.line, result.mended, parts.rings.empty()});
      }
      result.skipped = call_.skip_invalid && !parts.broken.empty();
      if (result.skipped) {
        input_.skipped.push_back({0, result.feature, result.line, parts.broken});
        continue;
      }
      result.open = std::move(parts.open);
      if (!call_.lists() && result.open.size() > 1) result.open.resize(1);
      result.count = result.open.size();
      const bool asks = call_.lists() || result.open.empty();  // one defect of each is enough
      std::vector<PolygonDefect> defects;
      if (asks) {
        const auto [count, cost] = visit_by_method(parts.rings, [&](const PolygonDefect& defect) {
          defects.push_back(defect);
          return held + defects.size() <= most_held;
        });
        result.count += count;
        cost_.probes += cost.probes;
      }
      if (held + result.count <= most_held) {
        held += defects.size();
        result.held = std::move(defects);
      }
      ++asked_;
      valid_ += result.valid() ? 1u : 0u;
      defects_ += result.count;
    }
  }

  // Calls for each feature that was asked about, with its parts, and what visits its defects, in their order, once.
  template <class OfFeature>
  void for_each_feature(const OfFeature& of_feature) const {
    io::PolygonPartsReader reader(file());
    io::PolygonParts parts;
    for (const SimpleResult& result : results_) {
      reader.next(parts);
      if (call_.mend) mend(parts);
      if (result.skipped) continue;
      of_feature(result, std::span<const PolygonRings>(parts.rings), [&](const PolygonDefectVisitor& visit) {
        if (result.held) {
          static_cast<void>(std::all_of(result.held->begin(), result.held->end(), visit));
        } else {
          static_cast<void>(visit_by_method(parts.rings, visit));
        }
      });
    }
  }

  // A statement for each feature that is valid, and for each defect that is listed.
  void prove() const {
    if (defects_ > most_proved) {
      throw Error(ErrorCode::bad_call,
                  fmt::format("{} defects, and their proofs would have about {:.1f} GB; leave out --all", defects_,
                              static_cast<double>(defects_) * 150 / 1e9),
                  "--certificate");
    }
    std::uint64_t entries = 0;
    for_each_feature([&](const SimpleResult&, const auto& parts, const VisitDefects&) { entries += parts.size(); });
    write_proof(
        talk_, call_.certificate, origin_of(input_, "polygons", call_.drop_z, {entries}), [this](ClaimsWriter& claims) {
          claims.begin_table("polygons");
          for_each_feature([&](const SimpleResult&, const auto& parts, const VisitDefects&) {
            if (!parts.empty()) planar::write_parts(claims, parts);
          });
          claims.end_table();
          std::uint32_t first = 0;
          for_each_feature([&](const SimpleResult& result, const auto& parts, const VisitDefects& visit) {
            if (parts.empty()) return;
            if (!result.open.empty()) {
              throw Error(
                  ErrorCode::bad_call,
                  fmt::format("{}: that a ring does not end where it began has no proof here; leave it out, or give "
                              "--skip-invalid",
                              feature_text(result)),
                  "--certificate");
            }
            planar::ValidClaims valid(claims, parts, first, call_.rule());
            if (result.valid()) valid.write_valid();
            visit([&](const PolygonDefect& defect) {
              if (valid.write_defect(defect)) return true;
              throw Error(ErrorCode::bad_call,
                          fmt::format("{}: one of its defects, {}, has no proof here; leave it out",
                                      feature_text(result), text_of(defect, result.has_parts())),
                          "--certificate");
            });
            first += static_cast<std::uint32_t>(parts.size());
          });
        });
  }

  // Of a result, or of a skipped feature: "feature 7 (Antarctica), line 8".
  std::string feature_text(const auto& f) const {
    return fmt::format("feature {}{}{}", input_.feature_text(0, f.feature),
                       f.line > 0 ? fmt::format(", line {}", f.line) : "",
                       words_of(call_.properties, file().properties, f.feature));
  }

  // The first defects of a feature.
  std::string defects_text(const SimpleResult& result, const VisitDefects& visit) const {
    std::string text = fmt::format("{}: {}\n", feature_text(result), call_.answer(false));
    std::size_t listed = 0;
    for (const io::OpenRing& open : result.open) {
      if (++listed > most_listed) break;
      text += fmt::format("  {:16}{}\n", "open-ring", open_text(open, result.has_parts()));
    }
    if (listed < most_listed) {
      visit([&](const PolygonDefect& defect) {
        text += fmt::format("  {:16}{}\n", name_of(defect.kind), text_of(defect, result.has_parts()));
        return ++listed < most_listed;
      });
    }
    listed = std::min(listed, most_listed);
    if (result.count > listed) {
      text += fmt::format("  and {} more; --json or --geojson have all\n", result.count - listed);
    }
    return text;
  }

  std::string text() const {
    std::string text;
    std::uint64_t listed = 0, mended = 0;
    for_each_feature([&](const SimpleResult& result, const auto&, const VisitDefects& visit) {
      if (result.mended.all() > 0 && ++mended <= most_listed) {
        text += fmt::format("{}: mended: {}\n", feature_text(result), text_of(result.mended));
      }
      if (!result.valid() && ++listed <= most_listed) text += defects_text(result, visit);
    });
    if (listed > most_listed) {
      text += fmt::format("and {} more; --json or --geojson have all\n", count_of(listed - most_listed, "feature"));
    }
    const std::size_t skipped = input_.skipped.size();
    for (std::size_t k = 0; k < skipped && k < most_listed; ++k) {
      const io::SkippedFeature& f = input_.skipped[k];
      text += fmt::format("{}: skipped: {}\n", feature_text(f), f.why);
    }
    if (skipped > most_listed) text += fmt::format("and {} more skipped; --json has all\n", skipped - most_listed);
    text += fmt::format("{}: {}, {}, {}\n", io::one_line(call_.file), valid_text(), count_of(edges_, "edge"),
                        file().format);
    if (valid_ < asked_ && !call_.lists()) text += "one defect of each is named; --all lists all\n";
    if (mended > 0) text += fmt::format("mended before the answer: {}\n", count_of(mended, "feature"));
    if (skipped > 0)
      text += fmt::format("the answer does not cover what was skipped: {}\n", count_of(skipped, input_.skipped_kind));
    if (!input_.left_out.empty()) text += fmt::format("left out: {}\n", input_.left_out.text());
    for (const std::string& remark : file().remarks) text += fmt::format("remark: {}\n", remark);
    if (!input_.systems.declared().empty()) text += fmt::format("crs: {}\n", input_.systems.text());
    if (call_.proves()) text += fmt::format("proof: {}\n", io::one_line(call_.certificate));
    if (call_.proves() && !not_proved().empty()) text += fmt::format("not proved: {}\n", not_proved()[0]);
    return text;
  }

  std::vector<std::string> not_proved() const {
    if (defects_ > 0 && call_.lists()) return {"that there are no other defects"};
    return {};
  }

  // Prints the report, each feature and each defect as it comes.
  void print_report() const {
    Report report{.verb = "simple", .answer = call_.answer(valid_ == asked_), .method = call_.method, .cost = cost_};
    report.function = call_.method == "scan" ? "planar::polygon_defects_by_scan"
                      : call_.lists()        ? "planar::visit_polygon_defects"
                                             : "planar::polygon_defects";
    report.notes = talk_.notes();
    report.add("rule", call_.strict ? "simple" : call_.self_touch ? "self-touch" : "valid");
    report.add(facts_of(input_));
    report.add(facts_of(input_.systems));
    report.is_proved = call_.proves();
    report.not_proved = not_proved();
    ListReport objects(talk_, json_of(report), "objects");
    for_each_feature([&](const SimpleResult& result, const auto&, const VisitDefects& visit) {
      const auto& rings = result.rings_of_part;
      Json object = {{"file", io::one_line(call_.file)},
                     {"format", file().format},
                     {"feature", result.feature + 1},
                     {"name", name(result)},
                     {"parts", rings.size()},
                     {"rings", std::accumulate(rings.begin(), rings.end(), 0u)},
                     {"edges", result.edges},
                     {"answer", call_.answer(result.valid())}};
      add_properties(result, object);
      objects.add_list(object, "defects", [&](ListStream& defects) {
        const auto add = [&](const auto& defect) {
          Json entry = defect_json(defect, result.has_parts());
          entry["at"] = at_json(defect);
          defects.add(entry.on_one_line());
          return true;
        };
        static_cast<void>(std::all_of(result.open.begin(), result.open.end(), add));
        visit(add);
      });
    });
    objects.close();
  }

  // Each defect as a point, or a line where a piece is in common; a line of the text for each.
  void write_geojson() const {
    GeojsonFile geojson(talk_, call_.geojson, input_.systems);
    for_each_feature([&](const SimpleResult& result, const auto&, const VisitDefects& visit) {
      const auto add = [&](const auto& defect) {
        const Json at = at_json(defect);
        Json geometry = {{"type", "Point"}, {"coordinates", at[0]}};
        if (at.size() > 1) geometry = {{"type", "LineString"}, {"coordinates", at}};
        Json properties = {{"feature", result.feature + 1}, {"name", name(result)}};
        add_properties(result, properties);
        properties.update(defect_json(defect, result.has_parts()));
        const Json feature = {{"type", "Feature"}, {"geometry", geometry}, {"properties", properties}};
        geojson.add(feature.compact());
        return true;
      };
      static_cast<void>(std::all_of(result.open.begin(), result.open.end(), add));
      visit(add);
    });
    geojson.close();
  }

  // All defects. (Of an open ring there is no picture: io::read_lines refuses it, or it is skipped.)
  std::string picture() const {
    const planar::Segments segments(file().segments);
    std::vector<picture::PicturedDefect> defects;
    for_each_feature([&](const SimpleResult& result, const auto&, const VisitDefects& visit) {
      const auto edge = [&](const RingPlace& place) {
        const auto parts = result.rings_of_part.begin();
        const std::uint32_t ring = std::accumulate(parts, parts + place.part, result.first_ring + place.ring);
        return file().rings[ring].first + place.edge;
      };
      visit([&](const PolygonDefect& defect) {
        const std::uint32_t i = edge(defect.a), j = edge(defect.b);
        const bool both = segment_segment(segments[i], segments[j]) != planar::ContactKind::none;
        defects.push_back({i, both ? j : i, defect.place, name_of(defect.kind), text_of(defect, result.has_parts())});
        return true;
      });
    });
    std::string said = fmt::format("{}, {}", valid_text(), count_of(defects_, "defect"));
    if (const std::string words = input_.left_out_words(); !words.empty()) said += "; " + words;
    const std::string title = call_.title_or("Are these polygons " + call_.answer(true) + "?");
    return picture::segments_svg({file(), segments, {}, said, title, false, defects});
  }

  std::string valid_text() const {
    return fmt::format("{} of {} {}", valid_, count_of(asked_, "feature"), call_.answer(true));
  }

  const SimpleCall& call_;
  Talk& talk_;
  PolygonsInput input_;  // without the polygons themselves
  std::vector<SimpleResult> results_;
  std::uint64_t asked_ = 0, valid_ = 0, edges_ = 0, defects_ = 0;
  Cost cost_;
};

constexpr const char* simple_methods = "automatic, scan";

bool has_ending_of_meshes(const std::string& file) {
  constexpr std::array<std::string_view, 9> endings{".obj",  ".stl", ".ply", ".off", ".dae",
                                                    ".gltf", ".glb", ".wrl", ".3mf"};
  return std::find(endings.begin(), endings.end(), io::ending_of(file)) != endings.end();
}

// Throws Error bad_call for an option that is for polygons of the plane alone.
void require_for_meshes(const SimpleCall& call) {
  const std::pair<bool, const char*> options[] = {{call.strict, "--strict"},
                                                  {call.self_touch, "--self-touch"},
                                                  {!call.geojson.empty(), "--geojson"},
                                                  {!call.svg.empty(), "--svg"},
                                                  {!call.name.empty(), "--name"},
                                                  {!call.properties.empty(), "--property"},
                                                  {call.skip_invalid, "--skip-invalid"},
                                                  {call.mend, "--mend"},
                                                  {call.drop_z, "--drop-z"},
                                                  {call.mixed_crs, "--mixed-crs"}};
  for (const auto& [is_given, option] : options) {
    if (is_given) {
      throw Error(ErrorCode::bad_call,
                  fmt::format("is for polygons of the plane, and {} is a mesh; leave it out",
                              io::quote(io::one_line(call.file))),
                  option);
    }
  }
}

Report run(const SimpleCall& call, Talk& talk) {
  if (has_ending_of_meshes(call.file)) {
    require_for_meshes(call);
    SimpleMeshCall of_mesh;
    static_cast<QuestionCall&>(of_mesh) = call;
    of_mesh.file = call.file;
    of_mesh.all = call.all;
    of_mesh.leave_out = call.leave_out;
    return run_simple_mesh(of_mesh, talk);
  }
  if (call.method != "automatic" && call.method != "scan") refuse_method(call.method, simple_methods);
  require_different(call.properties);
  return told(ValidQuestion(call, talk).answer());
}

}  // namespace

Verb simple_verb() {
  const auto call = std::make_shared<SimpleCall>();
  return {
      "simple",
      "Are the polygons in a file valid? Does a mesh bound a body, and not cross itself? If not, what is wrong, and "
      "where?",
      "0 all are valid; 1 some are not",
      {{"FILE", &call->file, "polygons (WKT, GeoJSON, or a JSON list of rings), or a mesh (OBJ, STL, PLY, OFF, ...)",
        "", true},
       {"--all", &call->all,
        "list all defects of each feature (default: one for each feature); all crossings of a mesh"},
       {"--strict", &call->strict,
        "also require that no vertex is repeated, and that no two rings have a common point"},
       {.name = "--self-touch",
        .value = &call->self_touch,
        .help = "allow a ring to touch itself in points",
        .excludes = {"--strict"}},
       {"--method", &call->method, simple_methods, "NAME"},
       certificate_option(call->certificate,
                          "write a proof for each feature to FILE: that it is valid, or has the listed defects"),
       {"--geojson", &call->geojson, "write all defects to FILE, as points and lines", "FILE"},
       {"--svg", &call->svg, "draw the polygons and all defects to FILE", "FILE"},
       title_option(call->title),
       {"--leave-out", &call->leave_out, leave_out_help},
       {"--name", &call->name, name_help, "FIELD"},
       property_option(call->properties, "of each feature"),
       {"--skip-invalid", &call->skip_invalid, "answer for the features whose rings are closed, and list the others"},
       {.name = "--mend",
        .value = &call->mend,
        .help = "close open rings, remove repeated vertices, spikes and rings without area, then examine the rest",
        .excludes = {"--svg"}},
       svg_limit_option(call->svg_limit),
       memory_option(call->memory),
       {"--drop-z", &call->drop_z, "ignore the third coordinate of each point"},
       {"--mixed-crs", &call->mixed_crs, mixed_crs_help},
       json_option(call->json)},
      [call](Talk& talk) { return run(*call, talk); }};
}

}  // namespace sunder::ask
