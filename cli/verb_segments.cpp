// sunder segments FILE: do any two segments meet? Which? How many?
#include <cli/common.h>
#include <cli/contacts_geojson.h>
#include <cli/progress.h>
#include <cli/segments_picture.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/lines.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/segments_all.h>
#include <sunder/planar/set/segments_any_json.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

namespace sunder::cli {

namespace {

using planar::ContactKind;
using planar::Segment;
using planar::Segments;
using planar::SegmentsAnswer;
using planar::SegmentsOptions;

struct Call {
  std::string file;
  bool any = false, all = false, count = false;  // at most one; none: any
  std::string group, layer;
  bool across_layers = false;
  std::string allow = "nothing";
  std::string method = "automatic";
  std::string certificate, geojson, svg, title;
  bool drop_z = false;
  bool json = false;

  bool lists() const { return all || !geojson.empty() || !svg.empty(); }
};

// What is asked about together: all of a file, or one layer of it.
struct Sheet {
  std::vector<std::uint32_t> members;  // segments of the file
  Segments segments;
  std::vector<std::uint32_t> groups;
  std::string layer;  // its name, where it is one of several sheets
};

struct Result {
  std::vector<planar::SegmentsContact> contacts;  // by numbers of the file; with --any at most one
  std::uint64_t count = 0;                        // with --all and --count
  std::vector<std::string> proofs;                // files written
  Cost cost;
};

using AnyMethod = SegmentsAnswer(const Segments&, const SegmentsOptions&);
AnyMethod* any_method(const std::string& name) {
  if (name == "automatic") return planar::segments_any;
  if (name == "grid") return planar::segments_any_by_grid;
  if (name == "sweep") return planar::segments_any_by_sweep;
  if (name == "bentley-ottmann") return planar::segments_any_by_bentley_ottmann;
  if (name == "scan") return planar::segments_any_by_scan;
  refuse_method(name, "automatic, grid, sweep, bentley-ottmann, scan");
}
planar::ContactMethod* contact_method(const std::string& name) {
  if (name == "automatic") return planar::visit_contacts;
  if (name == "grid") return planar::visit_contacts_by_grid;
  if (name == "bentley-ottmann") return planar::visit_contacts_by_bentley_ottmann;
  if (name == "balaban") return planar::visit_contacts_by_balaban;
  if (name == "scan") return planar::visit_contacts_by_scan;
  refuse_method(name, "automatic, grid, bentley-ottmann, balaban, scan (for lists and counts)");
}

// The layers that are asked about, each a sheet; or one sheet of all.
std::vector<Sheet> sheets_of(const Call& call, const io::LineFile& file) {
  const bool has_layers = !file.layers.empty();
  if (!has_layers && (!call.layer.empty() || call.across_layers)) {
    throw Error(ErrorCode::bad_call, fmt::format("{} has no layers; leave it out", call.file),
                call.layer.empty() ? "--across-layers" : "--layer");
  }
  std::vector<std::vector<std::uint32_t>> members(has_layers && !call.across_layers ? file.layers.size() : 1);
  for (std::uint32_t i = 0; i < file.segments.size(); ++i) {
    if (!call.layer.empty() && file.layers[file.layer[i]] != call.layer) continue;
    members[members.size() > 1 ? file.layer[i] : 0].push_back(i);
  }
  std::vector<Sheet> sheets;
  for (std::vector<std::uint32_t>& m : members) {
    if (m.empty()) continue;
    std::vector<Segment> segments;
    std::vector<std::uint32_t> groups;
    for (const std::uint32_t i : m) {
      segments.push_back(file.segments[i]);
      if (!file.group.empty()) groups.push_back(file.group[i]);
    }
    const std::string layer = members.size() > 1 && call.layer.empty() ? file.layers[file.layer[m[0]]] : "";
    sheets.push_back({std::move(m), Segments(segments), std::move(groups), layer});
  }
  if (sheets.empty()) {
    throw Error(
        ErrorCode::bad_call,
        fmt::format("no segment is on a layer {}; layers are {}", io::quote(call.layer), fmt::join(file.layers, ", ")),
        "--layer");
  }
  return sheets;
}

// "proof.json", or of a layer among others "proof.F.Cu.json".
std::filesystem::path certificate_of(const Call& call, const Sheet& sheet) {
  std::filesystem::path path = call.certificate;
  if (sheet.layer.empty()) return path;
  const std::string ending = path.extension().string();
  return path.replace_extension("." + sheet.layer + ending);
}

void ask(const Call& call, const Sheet& sheet, const SegmentsOptions& options, Result& result) {
  const auto in_file = [&](std::uint32_t i, std::uint32_t j, ContactKind kind) {
    return planar::SegmentsContact{sheet.members[i], sheet.members[j], kind};  // members rise, so i < j stays
  };
  if (call.lists() || call.count) {
    const Cost cost = contact_method(call.method)(sheet.segments, options, [&](const planar::SegmentsContact& c) {
      ++result.count;
      if (call.lists()) result.contacts.push_back(in_file(c.i, c.j, c.kind));
      return true;
    });
    result.cost.probes += cost.probes;
    return;
  }
  const SegmentsAnswer answer = any_method(call.method)(sheet.segments, options);
  result.cost.probes += answer.cost.probes;
  if (answer.meet()) result.contacts.push_back(in_file(answer.i, answer.j, answer.kind));
  if (call.certificate.empty()) return;
  result.proofs.push_back(certificate_of(call, sheet).string());
  io::write_file_atomically(result.proofs.back(),
                            planar::certificate_text(sheet.segments, options.allowed, answer, sheet.groups));
}

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

Point2 place_of(const io::LineFile& file, const planar::SegmentsContact& contact) {
  const Segments two(std::array{file.segments[contact.i], file.segments[contact.j]});
  return planar::common_point_rounded(two[0], two[1]);
}

std::string source_of(const io::LineFile& file, std::uint32_t i) {
  const io::LineSource& source = file.source[i];
  std::string place = fmt::format("feature {}", file.features[source.feature]);
  if (!file.layers.empty()) place += fmt::format(", layer {}", file.layers[file.layer[i]]);
  if (source.line > 0) place += fmt::format(", line {}", source.line);
  return place;
}

// "(touch allowed; members of one net may meet; layer by layer)"
std::string rule_text(const Call& call, const io::LineFile& file) {
  std::vector<std::string> rules;
  if (call.allow != "nothing") rules.push_back(call.allow + " allowed");
  if (!file.groups.empty())
    rules.push_back(fmt::format("those of one {} may meet", call.group.empty() ? "net" : call.group));
  if (!call.layer.empty()) rules.push_back("layer " + call.layer);
  if (!file.layers.empty() && call.layer.empty())
    rules.push_back(call.across_layers ? "across layers" : "each layer by itself");
  return rules.empty() ? "" : fmt::format(" ({})", fmt::join(rules, "; "));
}

constexpr std::size_t most_listed = 20;

std::string human_text(const Call& call, const io::LineFile& file, const Result& result) {
  std::string text = fmt::format("{}: {} of {}", call.file, count_of(file.segments.size(), "segment"),
                                 count_of(file.features.size(), "feature"));
  if (!file.layers.empty()) text += fmt::format(", {}", count_of(file.layers.size(), "layer"));
  if (!file.groups.empty()) text += fmt::format(", {}", count_of(file.groups.size(), "group"));
  text += fmt::format(", {}\n", file.format);
  const bool some = result.count > 0 || !result.contacts.empty();
  text += fmt::format("{} meet{}", some ? "some" : "none", rule_text(call, file));
  if (some && (call.lists() || call.count)) text += fmt::format(": {}", count_of(result.count, "pair"));
  text += '\n';
  for (std::size_t k = 0; k < std::min(result.contacts.size(), most_listed); ++k) {
    const planar::SegmentsContact& contact = result.contacts[k];
    text += fmt::format("{} {} at about {}\n", call.lists() ? fmt::format("  {}.", k + 1) : " ", name_of(contact.kind),
                        about(place_of(file, contact)));
    for (const std::uint32_t i : {contact.i, contact.j}) {
      text += fmt::format("    segment {}, {}: {} to {}\n", i, source_of(file, i), about(file.segments[i].a),
                          about(file.segments[i].b));
    }
  }
  if (result.contacts.size() > most_listed) {
    text += fmt::format("  and {} more; --json, --geojson or --svg have all\n", result.contacts.size() - most_listed);
  }
  const bool only_shared = some && !result.contacts.empty() &&
                           std::all_of(result.contacts.begin(), result.contacts.end(), [](const auto& contact) {
                             return contact.kind == ContactKind::shared_endpoint;
                           });
  if (only_shared) {
    text += "  edges that follow each other share an end: to pass over such contacts, give --allow shared-endpoint\n";
  }
  for (const std::string& remark : file.remarks) text += fmt::format("  remark      {}\n", remark);
  text += fmt::format("  cost        {}\n", count_of(result.cost.probes, "comparison"));
  for (const std::string& proof : result.proofs) text += fmt::format("  proof       {}\n", proof);
  if (!call.geojson.empty()) text += fmt::format("  contacts    {}\n", call.geojson);
  if (!call.svg.empty()) text += fmt::format("  picture     {}\n", call.svg);
  return text;
}

Json report(const Call& call, const io::LineFile& file, const Result& result) {
  const bool some = result.count > 0 || !result.contacts.empty();
  Json json = envelope("segments", some ? "some" : "none", call.method);
  json["cost"] = to_json(result.cost);
  Json object = {{"file", call.file},
                 {"format", file.format},
                 {"segments", file.segments.size()},
                 {"features", file.features.size()}};
  if (!file.groups.empty()) object["groups"] = file.groups.size();
  if (!file.layers.empty()) object["layers"] = file.layers;
  json["objects"] = Json::array({object});
  json["allowed"] = call.allow;
  if (!file.groups.empty()) json["group"] = call.group.empty() ? "net" : call.group;
  if (!file.layers.empty()) json["across_layers"] = call.across_layers;
  if (!call.layer.empty()) json["layer"] = call.layer;
  if (!file.remarks.empty()) json["remarks"] = file.remarks;
  if (call.lists() || call.count) json["count"] = result.count;
  json["contacts"] = Json::array();
  for (const planar::SegmentsContact& c : result.contacts) {
    const Point2 p = place_of(file, c);
    Json contact = {{"i", c.i}, {"j", c.j}, {"kind", name_of(c.kind)}, {"point", {p.x, p.y}}};
    for (const std::uint32_t i : {c.i, c.j}) {
      const io::LineSource& source = file.source[i];
      contact["features"].push_back(file.features[source.feature]);
      contact["lines"].push_back(source.line > 0 ? Json(source.line) : Json(nullptr));
      if (!file.groups.empty()) contact["groups"].push_back(file.groups[file.group[i]]);
      if (!file.layers.empty()) contact["layers"].push_back(file.layers[file.layer[i]]);
    }
    json["contacts"].push_back(contact);
  }
  return json;
}

// What can be told before the file is read.
void check(const Call& call) {
  if (call.lists() || call.count) {
    contact_method(call.method);
  } else {
    any_method(call.method);
  }
  if (call.certificate.empty()) return;
  if (call.lists() || call.count) {
    throw Error(ErrorCode::bad_call, "lists and counts have no proof; ask whether any two meet", "--certificate");
  }
  if (call.method == "scan") {
    throw Error(ErrorCode::bad_call, "scan writes no certificates; give automatic or sweep", "--method");
  }
}

io::LineFile read(const Call& call) {
  Progress progress("reading");
  return io::read_lines(call.file, {call.drop_z, call.group, progress.reporter()});
}

int run(const Call& call) {
  check(call);
  SegmentsOptions options;
  options.allowed = allowed_by(call.allow);
  options.transcript = !call.certificate.empty();
  const io::LineFile file = read(call);
  const std::vector<Sheet> sheets = sheets_of(call, file);
  Result result;
  for (const Sheet& sheet : sheets) {
    Progress progress("comparing");
    options.progress = progress.reporter();
    options.groups = sheet.groups;
    ask(call, sheet, options, result);
    if (!call.lists() && !call.count && !result.contacts.empty()) break;
  }
  std::sort(result.contacts.begin(), result.contacts.end());
  if (!call.geojson.empty() || !call.svg.empty()) {
    const Segments segments(file.segments);
    if (!call.geojson.empty()) {
      io::write_file_atomically(call.geojson, contacts_geojson(file, segments, result.contacts));
    }
    const bool y_down = file.format == "KiCad board";
    if (!call.svg.empty()) {
      io::write_file_atomically(call.svg, segments_svg({file, segments, result.contacts, call.title, y_down}));
    }
  }
  print(call.json ? to_text(report(call, file, result)) : human_text(call, file, result));
  return result.contacts.empty() && result.count == 0 ? exit_code::no : exit_code::yes;
}

}  // namespace

void add_segments(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb =
      program.add_subcommand("segments", "Do any two segments of a file meet? Which, or a proof that none do.");
  verb->add_option("FILE", call->file, "segments, lines or polygons: CSV (x1,y1,x2,y2), WKT, GeoJSON, KiCad board")
      ->required();
  auto* any = verb->add_flag("--any", call->any, "does any pair meet? (unless told otherwise)");
  auto* all = verb->add_flag("--all", call->all, "list all pairs that meet");
  auto* count = verb->add_flag("--count", call->count, "count the pairs that meet");
  any->excludes(all)->excludes(count);
  all->excludes(count);
  verb->add_option("--allow", call->allow, "what does not count: nothing, shared-endpoint, or touch")
      ->type_name("KIND");
  verb->add_option("--group", call->group,
                   "segments that are the same in this may meet and cross: feature, ring, a column of the CSV, a "
                   "property of the GeoJSON; of a board net (unless told otherwise) or layer")
      ->type_name("FIELD");
  auto* layer = verb->add_option("--layer", call->layer, "of a board, this layer only")->type_name("NAME");
  verb->add_flag("--across-layers", call->across_layers, "of a board, tracks of different layers may meet too")
      ->excludes(layer);
  verb->add_option("--method", call->method,
                   "automatic, grid, sweep (not for lists), bentley-ottmann, balaban (for lists), or scan")
      ->type_name("NAME");
  verb->add_option("--certificate", call->certificate, "write the proof here")->type_name("FILE");
  verb->add_option("--geojson", call->geojson, "write all contacts here, to lay over a map")->type_name("FILE");
  auto* svg = verb->add_option("--svg", call->svg, "draw the segments and all contacts here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  verb->add_flag("--drop-z", call->drop_z, "ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
